package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.control.TimingRule;
import faultline.geometry.Degrees;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
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
}
