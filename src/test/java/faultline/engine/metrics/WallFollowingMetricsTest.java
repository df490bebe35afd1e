package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.control.WallSide;
import faultline.engine.CommandListener;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Runs in a square room of 4 m, measured from ground truth. */
class WallFollowingMetricsTest {

    private static RunResult run(ControllerSpec controller, double duration, SimulationSetup.TimedCommand... timeline) {
        return run(setup(controller, duration).withTimeline(List.of(timeline)));
    }

    private static SimulationSetup setup(ControllerSpec controller, double duration) {
        WorldSpec world = new WorldSpec(4, 4, true, 3, List.of());
        return SimulationSetup.of(world, new Pose(2, 2, 0.3))
                .withController(controller)
                .withDuration(duration);
    }

    private static RunResult run(SimulationSetup setup) {
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

    @ParameterizedTest
    @EnumSource
    void theWantedDistanceIsThatOfTheSensorWhereverItIsMounted(WallSide side) {
        String id = side == WallSide.LEFT ? "left" : "right";
        double sign = side == WallSide.LEFT ? 1 : -1;
        SensorSpec inside = RobotSpec.DEFAULT.sensor(id).orElseThrow().withMountPosition(new Vector2(0, sign * 0.02));
        RunResult result = run(setup(ControllerSpec.WallFollowing.DEFAULT.withSide(side), 80)
                .withRobot(RobotSpec.DEFAULT.withSensor(inside)));
        assertEquals(1, result.coverage().orElse(-1));
        assertTrue(result.distanceRms().orElse(1) < 0.001, () -> "error " + result.distanceRms());
    }

    @Test
    void ofASensorThatIsSwitchedOffTheDistanceIsFromTheSideOfThePlatform() {
        RobotSpec robot = RobotSpec.DEFAULT.withPlatform(0.25, 0.3, 0.3);
        SensorSpec left = robot.sensor("left").orElseThrow();
        SimulationSetup setup = setup(ControllerSpec.WallFollowing.DEFAULT, 1);
        assertEquals(0.35, CarryOnMetrics.wantedDistance(setup.withRobot(robot)).orElse(-1));
        assertEquals(
                0.40,
                CarryOnMetrics.wantedDistance(setup.withRobot(robot.withSensor(left.withOn(false))))
                        .orElse(-1));
    }

    /**
     * The robot passes most of the wall only at the new distance, and needs a few seconds to reach it. At a greater one
     * it does not come to the places in the corners: from 0.25 to 0.4 m, these are 0.1 m on both sides of each, and it
     * has passed one of the four before.
     */
    @ParameterizedTest
    @CsvSource({"0.25, 0.4, 0.955", "0.4, 0.2, 1"})
    void afterAChangeOfTheWantedDistanceTheNewOneCounts(double from, double to, double coverage) {
        ControllerSpec.WallFollowing start = ControllerSpec.WallFollowing.DEFAULT.withDistance(from);
        RunResult result = run(
                start,
                160,
                new SimulationSetup.TimedCommand(20, new Command.ConfigureController(start.withDistance(to))));
        assertEquals(coverage, result.coverage().orElse(-1), 0.005);
        assertTrue(result.distanceRms().orElse(1) < 0.04, () -> "error " + result.distanceRms());
    }

    @Test
    void afterAChangeOfTheWantedDistanceADeviationIsMeasuredFromTheNewOne() {
        ControllerSpec.WallFollowing start = ControllerSpec.WallFollowing.DEFAULT;
        RunResult result = run(
                start,
                160,
                new SimulationSetup.TimedCommand(1, new Command.ConfigureController(start.withDistance(0.4))),
                new SimulationSetup.TimedCommand(0, new Command.InjectFault("left", new Fault.Bias(0.02))));
        assertEquals(0.02, result.distanceRms().orElse(1), 0.001);
        assertEquals(0.94, result.coverage().orElse(-1), 0.005, "all but the corners");
    }

    @Test
    void theWantedDistanceIsThatOfASensorThatIsMovedDuringTheRun() {
        SensorSpec inside = RobotSpec.DEFAULT.sensor("left").orElseThrow().withMountPosition(new Vector2(0, 0.02));
        RunResult result = runFollower(80, new SimulationSetup.TimedCommand(1, new Command.ConfigureSensor(inside)));
        assertEquals(1, result.coverage().orElse(-1), 0.03);
        assertTrue(result.distanceRms().orElse(1) < 0.001, () -> "error " + result.distanceRms());
    }

    /** In a tick, the robot drives twice as far as the distance within which it passes a place, and farther. */
    @ParameterizedTest
    @CsvSource({"1, 0.1", "1, 0.2", "2, 0.1"})
    void whatARobotPassesBetweenTwoTicksCounts(double speed, double tick) {
        MotorSpec fast = new MotorSpec(RobotSpec.DEFAULT.motor().timeConstant(), 0.4, 12);
        RunResult result = run(SimulationSetup.of(new WorldSpec(10, 10, true, 3, List.of()), new Pose(5, 2, 0))
                .withRobot(RobotSpec.DEFAULT.withSpeed(speed).withMotor(fast))
                .withController(ControllerSpec.WallFollowing.DEFAULT.withDistance(0.4))
                .withTick(tick)
                .withDuration(100));
        assertEquals(Optional.empty(), result.collision());
        assertTrue(result.coverage().orElse(-1) > 0.96, () -> "coverage " + result.coverage());
    }

    /**
     * Returns what is measured of a robot that drives along a wall for 3 s, 0.03 m farther away than it should, in a
     * state of a controller from outside.
     */
    private static WallFollowingMetrics alongAWallIn(String state) {
        SimulationSetup setup = setup(new ControllerSpec.Recorded(0.25, 0, List.of()), 3)
                .withStart(new Pose(1, 0.25 + RobotSpec.DEFAULT.width() / 2 + 0.03, 0));
        Telemetry telemetry = Telemetry.ofState(ControllerState.of(state));
        Controller controller = observation -> new Decision(3, 3, telemetry);
        WallFollowingMetrics metrics = new WallFollowingMetrics(setup);
        try (Simulation simulation = new Simulation(setup, controller, ControllerMode.DIRECT, CommandListener.NONE)) {
            while (simulation.ticks() < setup.ticks()) {
                simulation.tick();
                metrics.observe(simulation);
            }
        }
        return metrics;
    }

    @ParameterizedTest
    @CsvSource({"FOLLOW, true, true", "GLIDE, true, true", "ROUND, true, false", "SEARCH, false, false"})
    void aControllerFromOutsideFollowsInItsOwnStates(String state, boolean passes, boolean follows) {
        WallFollowingMetrics metrics = alongAWallIn(state);
        assertEquals(passes, metrics.coverage().isPresent());
        assertEquals(follows, metrics.followRms().isPresent());
        metrics.followRms().ifPresent(error -> assertEquals(0.03, error, 1e-9));
    }

    @Test
    void beforeTheRobotReachesAWallThereIsNothingToMeasure() {
        RunResult result = runFollower(1);
        assertTrue(result.coverage().isEmpty() && result.distanceRms().isEmpty());
    }

    /** The same as of a run that begins with the wall follower, apart from the time before it. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aWallFollowerThatTheTimelineStartsIsMeasured(boolean drives) {
        ControllerSpec first = drives ? new ControllerSpec.Drive(0.2, 0.2) : new ControllerSpec.None();
        RunResult result = run(
                first,
                90,
                new SimulationSetup.TimedCommand(
                        5, new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT)));
        assertEquals(1, result.coverage().orElse(-1));
        assertTrue(result.distanceRms().orElse(1) < 0.001, () -> "error " + result.distanceRms());
        assertTrue(result.followRms().orElse(1) < 0.05, () -> "error " + result.followRms());
    }

    @Test
    void ofControllersThatFollowNoWallNothingIsSaid() {
        RunResult result = run(new ControllerSpec.Drive(1, 1), 10);
        assertTrue(result.coverage().isEmpty() && result.distanceRms().isEmpty());
    }

    /** Metrics of a robot that has been 0.05 m too far from the lower wall, and now wants 0.4 m and not 0.1 m. */
    private static WallFollowingMetrics afterAChangeFromTheWall() {
        ControllerSpec.WallFollowing near = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.1);
        double side = RobotSpec.DEFAULT.width() / 2;
        WallFollowingMetrics metrics = new WallFollowingMetrics(setup(near, 1));
        metrics.measureStart(near, RobotSpec.DEFAULT, new Vector2(2, side + 0.15), FollowerState.FOLLOW);
        metrics.measureStart(
                near.withDistance(0.4), RobotSpec.DEFAULT, new Vector2(2, side + 0.43), FollowerState.FOLLOW);
        return metrics;
    }

    /** The errors are 0.05 and 0.03 m. The second place is more than twice as far from the wall as was first wanted. */
    @Test
    void afterAChangeOfTheWantedDistanceWallsThatWereTooFarAreFound() {
        double error = Math.sqrt((0.05 * 0.05 + 0.03 * 0.03) / 2);
        assertEquals(error, afterAChangeFromTheWall().followRms().orElse(-1), 1e-12);
    }

    /** Places are compared 0.3 m nearer to the wall, but not behind it. */
    @ParameterizedTest
    @CsvSource({"0.53, 0.23", "0.3, 0", "0.15, 0"})
    void aPlaceNearerThanTheChangeOfTheWantedDistanceStaysOnItsSideOfTheWall(double y, double expected) {
        Vector2 place = afterAChangeFromTheWall().atStartDistance(new Vector2(2, y));
        assertEquals(2, place.x());
        assertEquals(expected, place.y(), 1e-12);
    }
}
