package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.WallSide;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * After a change of the wanted distance during a run, the robot moves there along the wall and does not treat its
 * slanted path as a corner.
 */
class LiveDistanceTest {

    private static final double CHANGE = 6.3;

    @ParameterizedTest
    @CsvSource({
        "0.25, 0.37",
        "0.25, 0.5",
        "0.25, 0.14",
        "0.24, 0.1",
        "0.13, 0.27",
        "0.16, 0.44",
        "0.44, 0.16",
        "0.46, 0.1"
    })
    void itFollowsTheWallAllTheWay(double before, double after) {
        WallFollowing spec = WallFollowing.DEFAULT.withDistance(before).withSide(WallSide.RIGHT);
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(12, 4, true, 3, List.of()), new Pose(0.8, 0.7, -0.4))
                .withController(spec)
                .withTimeline(
                        List.of(new TimedCommand(CHANGE, new Command.ConfigureController(spec.withDistance(after)))));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < CHANGE) {
                simulation.tick();
            }
            assertEquals(FollowerState.FOLLOW, simulation.telemetry().state());
            int transitions = simulation.telemetry().transitions();
            while (simulation.time() < CHANGE + 8) {
                simulation.tick();
                assertEquals(
                        transitions,
                        simulation.telemetry().transitions(),
                        () -> "at " + simulation.time() + " s: "
                                + simulation.telemetry().condition());
                double distance = simulation.pose().y() - 0.1;
                boolean arrived = Math.abs(distance - after) < 0.02;
                assertTrue(arrived || simulation.time() < CHANGE + 3, () -> "at " + distance + " m");
            }
        }
    }
}
