package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.walls.WallCircuit;
import faultline.geometry.Pose;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Circuits around a pole. */
class WallCircuitsTest {

    private static final SimulationSetup POLE = SimulationSetup.of(
            new WorldSpec(
                    4,
                    4,
                    false,
                    3,
                    List.of(new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(2, 2, 0)))),
            new Pose(1, 1, 0));

    private final WallCircuits circuits = new WallCircuits();

    private WallCircuit at(double distance) {
        return circuits.forCarryOn(POLE.withController(ControllerSpec.WallFollowing.DEFAULT.withDistance(distance)));
    }

    @Test
    void theLatestSixteenAreKept() {
        WallCircuit first = at(0.5);
        WallCircuit second = at(1);
        assertSame(first, at(0.5));
        for (int i = 0; i < 15; i++) {
            at(2 + i);
        }
        assertSame(first, at(0.5));
        assertNotSame(second, at(1));
    }

    /** A circuit at 3.2 km has a million places, and two million are kept. */
    @Test
    void circuitsThatAreLargeTogetherAreNotKept() {
        WallCircuit small = at(0.5);
        WallCircuit large = at(3200);
        assertSame(large, at(3200));
        assertSame(small, at(0.5));
        at(3201);
        assertSame(small, at(0.5));
        assertNotSame(large, at(3200));
    }
}
