package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.geometry.Degrees;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** TURN, MEASURE and ALIGN beside a long wall that the robot meets at 0.3 m/s and spins from at 60 degrees per second. */
class SpinManoeuvreTest {

    private static final double TURN_RATE = 60;

    private static BesideAWall aligned(Timing timing, double timeConstant, double headingDegrees) {
        RobotSpec robot = new RobotSpec(0.25, 0.20, 0.18, 0.3, Degrees.toRadians(TURN_RATE), new MotorSpec(timeConstant, 0.1, 6),
                RobotSpec.DEFAULT.sensors());
        WallFollowing follower = new WallFollowing(0.25, Hand.LEFT, 0, timing);
        return new BesideAWall(robot, follower, 1.2, headingDegrees).until(FollowerState.FOLLOW);
    }

    @ParameterizedTest
    @CsvSource({"0, 90", "0.05, 90", "0.2, 90", "0.05, 40", "0.05, 60", "0.05, 120", "0.05, 140"})
    void equalReadingsEndParallelWhateverTheMotorsAndTheApproach(double timeConstant, double headingDegrees) {
        assertEquals(0, aligned(Timing.EQUAL_READINGS, timeConstant, headingDegrees).headingDegrees(), 0.3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.05, 0.1})
    void thePaperToTheLetterEndsOffByWhatTheMotorsLose(double timeConstant) {
        BesideAWall robot = aligned(Timing.RANGE, timeConstant, 90);
        double sampling = TURN_RATE * Observed.DT;
        assertEquals(-TURN_RATE * timeConstant, robot.headingDegrees(), 2 * sampling, "it heads away from the wall by omega tau");
    }

    @Test
    void withTheDefaultMotorsThatIsAboutThreeDegrees() {
        assertEquals(-3, aligned(Timing.RANGE, 0.05, 90).headingDegrees(), 1);
    }

    @Test
    void itTurnsBackForHalfOfTheTimeBetweenTheFrames() {
        Telemetry telemetry = aligned(Timing.RANGE, 0.05, 90).telemetry();
        assertEquals((telemetry.tF4() - telemetry.tF3()) / 2, telemetry.tP(), 1e-12);
        assertTrue(telemetry.tF3() > 0 && telemetry.tP() > 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"EQUAL_READINGS", "RANGE"})
    void aWallMetSidewaysIsBackedOffFromAndThenTimedAsAnyOther(Timing timing) {
        RobotSpec robot = Observed.PROMPT;
        BesideAWall beside = new BesideAWall(robot, new WallFollowing(0.25, Hand.LEFT, 0, timing), 0.4, 5).until(FollowerState.FOLLOW);
        assertEquals(0, beside.headingDegrees(), 1.3);
        assertEquals(0.35, beside.distance(), 0.06);
    }
}
