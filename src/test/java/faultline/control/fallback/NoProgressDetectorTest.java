package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.control.diagnosis.DeadReckoning;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A square of 0.4 m at 0.2 m/s: a position every half second, and a period of 30 s. */
class NoProgressDetectorTest {

    private static final RobotSpec PROMPT =
            RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6)).withSensors(List.of());
    private static final double DT = 0.1;
    private static final double SIDE = 0.4;
    private static final double SPEED = 0.2;

    private final SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
    private final DeadReckoning at = diagnosis.reckoning();
    private final NoProgressDetector detector = new NoProgressDetector();

    private boolean drive(double left, double right) {
        diagnosis.update(new Observation(0, DT, PROMPT, new double[0]), left, right, 1);
        return detector.isStuck(at, SIDE, SPEED, DT);
    }

    /** Drives until there is no progress, and returns after how many seconds that is, at most 120. */
    private double secondsUntilStuck(double left, double right) {
        for (int i = 1; i <= 1200; i++) {
            if (drive(left, right)) {
                return i * DT;
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "-1, 1", "0.4, 1.2"})
    void aRobotThatStaysInTheSquareMakesNoProgress(double left, double right) {
        assertEquals(29.6, secondsUntilStuck(left, right), 0.15);
    }

    @Test
    void aCircleThatIsWiderThanTheSquareIsProgress() {
        // The diameter is 0.54 m.
        assertEquals(Double.POSITIVE_INFINITY, secondsUntilStuck(1, 2));
    }

    @Test
    void backAndForthAlongEitherAxisIsProgressIfItIsFar() {
        for (int quarter = 0; quarter < 2; quarter++) {
            for (int i = 0; i < 800; i++) {
                double volts = i / 25 % 2 == 0 ? 2 : -2;
                assertFalse(drive(volts, volts), "0.5 m, leg " + i / 25);
            }
            turnLeft();
        }
    }

    private void turnLeft() {
        double rest = Math.PI / 2 - at.heading();
        double volts = rest * 0.18 / 2 / 0.1 / DT / 20;
        for (int i = 0; i < 20; i++) {
            drive(-volts, volts);
        }
        assertEquals(Math.PI / 2, at.heading(), 1e-9);
    }

    @Test
    void positionsBeforeAResetDoNotCount() {
        for (int i = 0; i < 250; i++) {
            drive(0, 0);
        }
        detector.reset();
        assertEquals(29.6, secondsUntilStuck(0, 0), 0.15);
        detector.reset();
        assertFalse(drive(0, 0));
    }

    /** The first step of a controller that replaces another one lasts as long as the run so far. */
    @Test
    void aLongStepIsNoLongPeriod() {
        assertFalse(detector.isStuck(at, SIDE, SPEED, 1000));
        assertEquals(29, secondsUntilStuck(0, 0), 0.15);
    }

    @Test
    void positionsOfLongAgoDoNotCount() {
        for (int i = 0; i < 400; i++) {
            assertFalse(drive(2, 2));
        }
        double seconds = secondsUntilStuck(0, 0);
        assertTrue(seconds < 30, "stands for " + seconds);
        assertTrue(seconds > 27, "stands for " + seconds);
    }
}
