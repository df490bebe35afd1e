package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.SensorFinding;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A front sensor that does not see the surface which the sensor beside it foresees. */
class MissedSurfaceTest {

    private static Simulation start(double boxY, double boxWidth, List<TimedCommand> timeline) {
        Obstacle box = new Obstacle("box", new ObstacleShape.RectangleShape(0.6, boxWidth), new Pose(3.5, boxY, 0));
        SimulationSetup setup = new SimulationSetup(
                new WorldSpec(8, 8, true, 3, List.of(box)),
                RobotSpec.DEFAULT,
                new Pose(2, 4, 0),
                ControllerSpec.WallFollowing.DEFAULT,
                timeline,
                0.01,
                1,
                60);
        return new Simulation(setup, ControllerMode.DIRECT);
    }

    /** Runs until the front sensor is blind, and returns when. */
    private static double untilBlind(Simulation simulation) {
        while (simulation.telemetry().diagnosis().health().isEmpty() || finding(simulation) == SensorFinding.NONE) {
            simulation.tick();
            assertTrue(simulation.time() < 10, "no alarm");
        }
        assertEquals(SensorFinding.BLIND, finding(simulation));
        return simulation.time();
    }

    private static SensorFinding finding(Simulation simulation) {
        return simulation.telemetry().diagnosis().health().get(0).finding();
    }

    /** The corner of the box is between the two cones, so that the foreseen surface is not on the way. */
    @Test
    void isTrustedAgainWhenThePlaceIsSeenFree() {
        Simulation simulation = start(3.6, 0.4, List.of());
        double blind = untilBlind(simulation);
        while (finding(simulation) != SensorFinding.NONE) {
            simulation.tick();
            assertTrue(simulation.time() < blind + 5, "not trusted for 5 s");
        }
        assertEquals("ALL", simulation.telemetry().diagnosis().rung());
        assertTrue(simulation.collision().isEmpty());
    }

    @Test
    void isNotTrustedWhereThePlaceIsNotFree() {
        TimedCommand fault =
                new TimedCommand(0.5, new Command.InjectFault("front", FaultKind.STUCK_AT_LAST.createFault(0)));
        Simulation simulation = start(4, 3, List.of(fault));
        double blind = untilBlind(simulation);
        while (simulation.time() < blind + 10) {
            simulation.tick();
            assertTrue(finding(simulation) != SensorFinding.NONE, "trusted at " + simulation.time());
        }
        assertTrue(simulation.collision().isEmpty());
    }
}
