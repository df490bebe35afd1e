package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.Odometer;
import faultline.control.Telemetry;
import faultline.control.Threshold;
import faultline.control.TimingRule;
import faultline.geometry.Degrees;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * TURN, MEASURE and ALIGN beside a long wall that the robot meets at 0.3 m/s and spins from at 60 degrees per second.
 */
class AlignmentManoeuvreTest {

    private static final double TURN_RATE = 60;

    private static StraightWallFixture runToFollow(TimingRule timing, double timeConstant, double headingDegrees) {
        RobotSpec robot = new RobotSpec(
                0.25,
                0.20,
                0.18,
                0.3,
                Degrees.toRadians(TURN_RATE),
                new MotorSpec(timeConstant, 0.1, 6),
                DriveScale.NONE,
                RobotSpec.DEFAULT.sensors());
        WallFollowing follower = WallFollowing.DEFAULT.withTimingRule(timing);
        return new StraightWallFixture(robot, follower, 1.2, headingDegrees).runUntil(FollowerState.FOLLOW);
    }

    @ParameterizedTest
    @CsvSource({"0, 90", "0.05, 90", "0.2, 90", "0.05, 40", "0.05, 60", "0.05, 120", "0.05, 140"})
    void equalReadingsEndParallelForAnyMotorsAndApproach(double timeConstant, double headingDegrees) {
        assertEquals(
                0,
                runToFollow(TimingRule.EQUAL_READINGS, timeConstant, headingDegrees)
                        .headingDegrees(),
                0.3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.05, 0.1})
    void thePapersExactRuleEndsOffByWhatTheMotorsLose(double timeConstant) {
        StraightWallFixture robot = runToFollow(TimingRule.RANGE, timeConstant, 90);
        double sampling = TURN_RATE * Observations.DT;
        assertEquals(
                -TURN_RATE * timeConstant,
                robot.headingDegrees(),
                2 * sampling,
                "it heads away from the wall by omega tau");
    }

    @Test
    void withTheDefaultMotorsThatIsAboutThreeDegrees() {
        assertEquals(-3, runToFollow(TimingRule.RANGE, 0.05, 90).headingDegrees(), 1);
    }

    @Test
    void itTurnsBackForHalfOfTheTimeBetweenTheFrames() {
        Telemetry telemetry = runToFollow(TimingRule.RANGE, 0.05, 90).telemetry();
        assertEquals(
                (telemetry.edges().tF4() - telemetry.edges().tF3()) / 2,
                telemetry.edges().tP(),
                1e-12);
        assertTrue(telemetry.edges().tF3() > 0 && telemetry.edges().tP() > 0);
    }

    @Test
    void theClockHasAnOriginOnceTheWallIsMeasured() {
        StraightWallFixture robot = new StraightWallFixture(RobotSpec.DEFAULT, WallFollowing.DEFAULT, 1.2, 90);
        assertTrue(Double.isNaN(
                robot.runUntil(FollowerState.TURN).telemetry().edges().origin()));
        Telemetry turned = robot.runUntil(FollowerState.ALIGN).telemetry();
        double aligned = turned.sinceTick() * Observations.DT;
        assertEquals(aligned, turned.edges().origin() + turned.edges().tF4(), 3 * Observations.DT);
        assertEquals(
                turned.edges().origin(),
                robot.runUntil(FollowerState.FOLLOW).telemetry().edges().origin());
    }

    @ParameterizedTest
    @ValueSource(strings = {"EQUAL_READINGS", "RANGE"})
    void aWallMetSidewaysIsBackedOffFromAndThenTimedAsAnyOther(TimingRule timing) {
        RobotSpec robot = Observations.LAG_FREE_ROBOT;
        StraightWallFixture beside = new StraightWallFixture(
                        robot, WallFollowing.DEFAULT.withTimingRule(timing), 0.4, 5)
                .runUntil(FollowerState.FOLLOW);
        assertEquals(0, beside.headingDegrees(), 1.3);
        assertEquals(0.35, beside.distance(), 0.06);
    }

    /** Begins a manoeuvre after a search in which the left sensor sees a wall. */
    private static AlignmentManoeuvre beginBeside(StateEstimate estimate, double reading) {
        estimate.update(Observations.observation(0, Map.of("left", reading)));
        AlignmentManoeuvre alignment =
                new AlignmentManoeuvre(estimate, TimingRule.EQUAL_READINGS, SpinClock.TURNED_ANGLE);
        alignment.begin(true);
        return alignment;
    }

    @Test
    void aWallThatStaysAsFarIsBackedOffFromByAQuarterTurn() {
        StateEstimate estimate = new StateEstimate(WallFollowing.DEFAULT, new Odometer());
        AlignmentManoeuvre alignment = beginBeside(estimate, 0.25);
        for (int tick = 1; tick < 1000 && alignment.nextTurnRate() > 0; tick++) {
            Observations.drive(estimate, new Velocity(0, Math.toRadians(TURN_RATE)));
            estimate.update(Observations.observation(tick, Map.of("left", 0.25)));
        }
        assertEquals(90, Math.toDegrees(estimate.odometer().heading()), 1);
    }

    @ParameterizedTest
    @CsvSource({
        "0.25, 0, 0.149, true",
        "0.25, 0, 0.151, false",
        "0.25, 0.1, 0.249, true",
        "0.25, 0.1, 0.251, false",
        "0.25, -0.1, 0.149, true",
        "0.25, -0.1, 0.151, false",
        // 16 % of the distance from the centre, which is 1.6 m.
        "1.5, 0, 0.255, true",
        "1.5, 0, 0.257, false"
    })
    void onlyTheWallThatWasMetIsBackedOffFrom(double wanted, double aheadMargin, double excess, boolean isThatWall) {
        WallFollowing follower =
                WallFollowing.DEFAULT.withDistance(wanted).withThreshold(Threshold.AHEAD_MARGIN, aheadMargin);
        AlignmentManoeuvre alignment = beginBeside(new StateEstimate(follower, new Odometer()), wanted + excess);
        assertEquals(isThatWall, alignment.nextTurnRate() > 0);
    }
}
