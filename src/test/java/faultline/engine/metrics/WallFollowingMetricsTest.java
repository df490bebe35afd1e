package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Runs in a square room of 4 m, measured from ground truth. */
class WallFollowingMetricsTest {

    private static RunResult run(ControllerSpec controller, double duration, SimulationSetup.TimedCommand... timeline) {
        WorldSpec world = new WorldSpec(4, 4, true, 3, List.of());
        SimulationSetup setup = SimulationSetup.of(world, new Pose(2, 2, 0.3))
                .withController(controller)
                .withTimeline(List.of(timeline))
                .withDuration(duration);
        return HeadlessRun.run(setup, ControllerMode.DIRECT, List.of());
    }

    private static RunResult runFollower(double duration, SimulationSetup.TimedCommand... timeline) {
        return run(ControllerSpec.WallFollowing.DEFAULT, duration, timeline);
    }

    @Test
    void aLapOfASoundRobotIsAllOfTheWall() {
        RunResult result = runFollower(80);
        assertEquals(1, result.coverage().orElse(-1));
        assertTrue(result.distanceRms().orElse(1) < 0.001);
    }

    @Test
    void afterTheFirstSideItIsAboutAQuarter() {
        assertEquals(0.25, runFollower(20).coverage().orElse(-1), 0.15);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.03, -0.01, 0.02})
    void aLeftSensorThatIsOffByAConstantShowsAsThatError(double bias) {
        RunResult result = runFollower(
                80, new SimulationSetup.TimedCommand(0, new Command.InjectFault("left", new Fault.Bias(bias))));
        assertEquals(Math.abs(bias), result.distanceRms().orElse(1), 0.001);
        assertEquals(1, result.coverage().orElse(-1), 0.03, "it is within 5 cm of its place");
    }

    @Test
    void beforeTheRobotReachesAWallThereIsNothingToMeasure() {
        RunResult result = runFollower(1);
        assertTrue(result.coverage().isEmpty() && result.distanceRms().isEmpty());
    }

    @Test
    void ofControllersThatFollowNoWallNothingIsSaid() {
        RunResult result = run(new ControllerSpec.Drive(1, 1), 10);
        assertTrue(result.coverage().isEmpty() && result.distanceRms().isEmpty());
    }
}
