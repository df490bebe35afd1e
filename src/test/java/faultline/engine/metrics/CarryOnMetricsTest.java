package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.engine.SimulationSetup;
import faultline.engine.walls.WallCircuit;
import faultline.engine.walls.WallReference;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The verdict on a robot at 0.5 m/s whose fault begins at 5 s, beside a wall of 12.5 m along y = 0 and one of 5 m along
 * y = 5. It has 2 (12.5 / 0.5 + 10) = 70 s for the long wall and 40 s for the short one.
 */
class CarryOnMetricsTest {

    private static final double SPACING = 0.125;
    private static final double ONSET = 5;

    /** The robot passes 80 of the 100 places of the long wall if it drives as far as this, and 79 up to the second. */
    private static final double ENOUGH = 9.8;

    private static final double TOO_LITTLE = 9.675;

    private final CarryOnMetrics metrics = new CarryOnMetrics(circuit(), 0.5, ONSET);

    private static WallCircuit circuit() {
        List<WallReference.WallSample> places = new ArrayList<>();
        for (int i = 0; i < 100; i++) {
            places.add(new WallReference.WallSample(new Vector2(i * SPACING, 0), new Vector2(0, 0.35), SPACING));
        }
        for (int i = 0; i < 40; i++) {
            places.add(new WallReference.WallSample(new Vector2(i * SPACING, 5), new Vector2(0, 0.35), SPACING));
        }
        return new WallCircuit(places, SPACING, 0.13, 0.16);
    }

    /** Drives along the long wall at a time, in steps of 25 mm. */
    private void drive(double time, double from, double to) {
        int steps = (int) Math.round(Math.abs(to - from) / 0.025);
        for (int i = 0; i <= steps; i++) {
            metrics.update(time, new Vector2(from + (to - from) * i / steps, 0), FollowerState.FOLLOW, false);
        }
    }

    @Test
    void fourFifthsOfTheWallInTimeAreEnough() {
        drive(ONSET, 0, TOO_LITTLE);
        assertEquals(OptionalDouble.of(0.79), metrics.share());
        assertFalse(metrics.carriedOn());
        drive(75, TOO_LITTLE, ENOUGH);
        assertEquals(OptionalDouble.of(0.8), metrics.share());
        assertTrue(metrics.carriedOn());
        assertFalse(metrics.isDecided());
        drive(75.01, ENOUGH, 0);
        assertTrue(metrics.isDecided() && metrics.carriedOn(), "what is passed in time counts later, too");
    }

    @Test
    void whatIsPassedTooLateOrBeforeTheFaultIsNotEnough() {
        drive(4.99, 0, 12);
        assertEquals(OptionalDouble.empty(), metrics.share());
        assertEquals(OptionalDouble.empty(), metrics.laps());
        assertEquals(OptionalDouble.empty(), metrics.clockStart());
        drive(ONSET, 0, TOO_LITTLE);
        drive(75.01, TOO_LITTLE, ENOUGH);
        assertEquals(OptionalDouble.of(0.8), metrics.share());
        assertFalse(metrics.carriedOn());
    }

    @Test
    void theClockStartsWhenTheRobotMeetsAWall() {
        metrics.update(20, new Vector2(0, 0), FollowerState.SEARCH, false);
        assertEquals(OptionalDouble.empty(), metrics.clockStart());
        drive(25, 0, TOO_LITTLE);
        drive(95, TOO_LITTLE, ENOUGH);
        assertEquals(OptionalDouble.of(25), metrics.clockStart());
        assertTrue(metrics.carriedOn());
    }

    @Test
    void aRobotThatMeetsNoWallHasTheTimeOfTheLongestWall() {
        metrics.update(75, new Vector2(0, 2), FollowerState.SEARCH, false);
        assertFalse(metrics.isDecided());
        metrics.update(75.01, new Vector2(0, 2), FollowerState.SEARCH, false);
        assertTrue(metrics.isDecided());
        assertFalse(metrics.carriedOn());
    }

    @Test
    void aVerdictIsNotChangedByAWallThatIsMetTooLate() {
        metrics.update(75.01, new Vector2(0, 2), FollowerState.SEARCH, false);
        metrics.update(80, Vector2.ZERO, FollowerState.FOLLOW, false);
        drive(80, 0, 12);
        assertTrue(metrics.isDecided());
        assertFalse(metrics.carriedOn());
        assertEquals(OptionalDouble.empty(), metrics.clockStart());
    }

    @Test
    void whatAFastRobotPassesBetweenTwoTicksCounts() {
        metrics.update(ONSET, Vector2.ZERO, FollowerState.FOLLOW, false);
        metrics.update(ONSET + 1, new Vector2(ENOUGH, 0), FollowerState.FOLLOW, false);
        assertEquals(OptionalDouble.of(0.8), metrics.share());
        assertTrue(metrics.carriedOn());
    }

    @Test
    void onlyTheWallThatTheRobotMeetsFirstCounts() {
        metrics.update(ONSET, new Vector2(0, 4.9), FollowerState.FOLLOW, false);
        assertEquals(OptionalDouble.of(1 / 40.0), metrics.share());
        drive(ONSET, 0, 12);
        assertEquals(OptionalDouble.of(1 / 40.0), metrics.share());
        drive(45, 0, 1);
        assertFalse(metrics.isDecided());
        drive(45.01, 0, 1);
        assertTrue(metrics.isDecided());
    }

    @Test
    void aContactDecidesAtOnce() {
        metrics.update(1, new Vector2(0, 0), FollowerState.SEARCH, true);
        assertTrue(metrics.isDecided());
    }

    @Test
    void aContactLaterTakesTheVerdictBack() {
        drive(ONSET, 0, ENOUGH);
        assertTrue(metrics.carriedOn());
        metrics.update(6, new Vector2(ENOUGH, 0), FollowerState.FOLLOW, true);
        assertTrue(metrics.isDecided());
        assertFalse(metrics.carriedOn());
        assertEquals(OptionalDouble.of(0.8), metrics.share());
    }

    /** Six places, up to 0.625 m before the turn, are passed again before the robot has driven a metre. */
    @Test
    void aPlaceIsPassedAgainOnlyAfterAMetre() {
        drive(ONSET, 0, 12.375);
        assertEquals(OptionalDouble.of(1), metrics.laps());
        drive(ONSET, 12.375, 0);
        assertEquals(OptionalDouble.of(1.94), metrics.laps());
        assertEquals(OptionalDouble.of(1), metrics.share());
    }

    @Test
    void aPlaceThatIsPassedAgainAddsNothingToTheShare() {
        drive(ONSET, 0, 6);
        OptionalDouble share = metrics.share();
        drive(ONSET, 6, 0);
        assertEquals(share, metrics.share());
    }

    @Test
    void theFaultThatBeginsLastCountsAlsoIfItIsOfAMotor() {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1, 0))
                .withTimeline(List.of(
                        new SimulationSetup.TimedCommand(
                                5, new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.NoDrive())),
                        new SimulationSetup.TimedCommand(2, new Command.InjectFault("left", new Fault.Dead())),
                        new SimulationSetup.TimedCommand(9, new Command.SwitchSensor("rear", false))));
        CarryOnMetrics motor = new CarryOnMetrics(setup, circuit());
        motor.update(4.99, Vector2.ZERO, FollowerState.FOLLOW, false);
        assertEquals(OptionalDouble.empty(), motor.clockStart());
        motor.update(5, Vector2.ZERO, FollowerState.FOLLOW, false);
        assertEquals(OptionalDouble.of(5), motor.clockStart());
    }

    /** The product of 11 and 0.03, the time of the tick of the fault, is less than 0.33. */
    @Test
    void theClockStartsInTheTickOfTheFaultWhateverTheRoundingErrorOfItsTime() {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1, 0))
                .withTick(0.03)
                .withTimeline(List.of(
                        new SimulationSetup.TimedCommand(0.33, new Command.InjectFault("left", new Fault.Dead()))));
        CarryOnMetrics rounded = new CarryOnMetrics(setup, circuit());
        rounded.update(10 * setup.dt(), Vector2.ZERO, FollowerState.FOLLOW, false);
        assertEquals(OptionalDouble.empty(), rounded.clockStart());
        rounded.update(11 * setup.dt(), Vector2.ZERO, FollowerState.FOLLOW, false);
        assertEquals(OptionalDouble.of(11 * setup.dt()), rounded.clockStart());
    }

    /** The default distance is 0.25 m from the side of the platform, which is 0.2 m wide. */
    @Test
    void aControllerFromOutsideKeepsItsDistanceFromTheSideOfThePlatform() {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1, 0));
        assertEquals(
                0.35,
                CarryOnMetrics.wantedDistance(setup.withController(new ControllerSpec.Extern(0)))
                        .orElseThrow());
        assertEquals(
                OptionalDouble.empty(),
                CarryOnMetrics.wantedDistance(setup.withController(new ControllerSpec.Drive(1, 1))));
    }

    @Test
    void theClockDoesNotStartBeforeTheWallFollowerThatTheTimelineStarts() {
        ControllerSpec.WallFollowing later = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.3);
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1, 0))
                .withController(new ControllerSpec.Drive(1, 1))
                .withTimeline(List.of(
                        new SimulationSetup.TimedCommand(
                                7, new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT)),
                        new SimulationSetup.TimedCommand(5, new Command.ConfigureController(later)),
                        new SimulationSetup.TimedCommand(2, new Command.InjectFault("left", new Fault.Dead()))));
        assertEquals(CarryOnMetrics.wantedDistance(later, setup.robot()), CarryOnMetrics.wantedDistance(setup));
        CarryOnMetrics late = new CarryOnMetrics(setup, circuit());
        late.update(4.99, Vector2.ZERO, FollowerState.FOLLOW, false);
        late.update(5, Vector2.ZERO, ControllerState.of("DRIVE"), false);
        late.update(6, Vector2.ZERO, FollowerState.SEARCH, false);
        assertEquals(OptionalDouble.empty(), late.clockStart());
        late.update(7, Vector2.ZERO, FollowerState.TURN, false);
        assertEquals(OptionalDouble.of(7), late.clockStart());
    }

    @Test
    void ofTheControllersOfOneTickOnlyTheLastOneStarts() {
        ControllerSpec.WallFollowing last = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.3);
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1, 0))
                .withController(new ControllerSpec.None());
        List<SimulationSetup.TimedCommand> changes = Stream.of(
                        ControllerSpec.WallFollowing.DEFAULT, new ControllerSpec.None(), last)
                .map(Command.ConfigureController::new)
                .map(change -> new SimulationSetup.TimedCommand(5, change))
                .toList();
        assertEquals(
                CarryOnMetrics.wantedDistance(last, setup.robot()),
                CarryOnMetrics.wantedDistance(setup.withTimeline(changes)));
        assertEquals(OptionalDouble.empty(), CarryOnMetrics.wantedDistance(setup.withTimeline(changes.subList(0, 2))));
    }

    @Test
    void theClockDoesNotStartInAStateOfAControllerThatFollowsNoWall() {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1, 0));
        CarryOnMetrics built = new CarryOnMetrics(setup, circuit());
        built.update(3, Vector2.ZERO, ControllerState.of("NONE"), false);
        assertEquals(OptionalDouble.empty(), built.clockStart());
        CarryOnMetrics own = new CarryOnMetrics(setup.withController(new ControllerSpec.Extern(0)), circuit());
        own.update(3, Vector2.ZERO, ControllerState.of("NONE"), false);
        assertEquals(OptionalDouble.of(3), own.clockStart());
    }

    @Test
    void withoutAnyWallNothingIsDecided() {
        CarryOnMetrics open = new CarryOnMetrics(WallCircuit.empty(), 0.5, ONSET);
        open.update(1000, Vector2.ZERO, FollowerState.FOLLOW, false);
        assertFalse(open.isDecided());
        assertEquals(OptionalDouble.empty(), open.share());
    }
}
