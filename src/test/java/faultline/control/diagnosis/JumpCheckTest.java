package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A jump of the sensor that faces a straight wall is an error if the two others still see the wall as before. */
class JumpCheckTest {

    private static final double DT = 0.01;
    private static final double WALL = 0.35;
    private static final int LEFT = RobotSpec.DEFAULT.indexOf("left");
    private static final int FRONT_LEFT = RobotSpec.DEFAULT.indexOf("front-left");
    private static final int REAR_LEFT = RobotSpec.DEFAULT.indexOf("rear-left");
    /** The ticks after which the check has ended. */
    private static final int ENOUGH = 30;

    private final InspectedSensor[] sensors = IntStream.range(0, 8)
            .mapToObj(i -> new InspectedSensor(
                    i, MountedCone.of(RobotSpec.DEFAULT.sensors().get(i), WallSide.LEFT)))
            .toArray(InspectedSensor[]::new);
    private final MotionAccumulator motion = new MotionAccumulator();
    private final TrustAssessment assessment = new TrustAssessment(sensors.length);
    private final SensorInspection inspection = new SensorInspection(
            sensors,
            assessment,
            new EvidenceGrid(sensors.length + 1),
            new DeadReckoning(),
            new MotionClock(),
            motion,
            new HealthReport(RobotSpec.DEFAULT));
    private final JumpCheck check = new JumpCheck(motion, assessment, inspection);
    private final double[] errors = new double[sensors.length];

    @BeforeEach
    void begin() {
        inspection.refit(0.1);
        check.begin(new WallLine(sensors), WALL);
    }

    /** Returns what the sensors read beside a straight wall, with their errors, by looking along many rays. */
    private double[] readings(double heading) {
        double[] readings = new double[sensors.length];
        for (int i = 0; i < readings.length; i++) {
            MountedCone cone = sensors[i].cone();
            double mount = cone.x() * Math.sin(heading) + cone.y() * Math.cos(heading);
            double least = Reading.NOTHING;
            for (double off = -cone.half(); off <= cone.half(); off += cone.half() / 1000) {
                double towards = Math.sin(heading + cone.bearing() + off);
                least = towards > 0 ? Math.min(least, (WALL - mount) / towards) : least;
            }
            readings[i] = least < cone.range() ? least + errors[i] : Reading.NOTHING;
        }
        return readings;
    }

    /** Moves on for some ticks, turning by an angle in each, and returns the sensor that is suspected. */
    private int suspectedAfter(int ticks, double turn) {
        for (int i = 0; i < ticks && check.isDue(motion); i++) {
            motion.advance(0.003, turn, DT);
            check.run(readings(motion.heading()), i);
        }
        return IntStream.range(0, sensors.length)
                .filter(i -> assessment.evidence(i) > 0)
                .reduce(-1, Math::max);
    }

    @ParameterizedTest
    @CsvSource({"0.032, 0", "-0.032, 0", "0.1, 0.01", "-0.1, -0.01", "0.4, 0.018", "0.05, 0.015", "0.05, -0.015"})
    void theOtherTwoShowThatItIsWrong(double error, double turn) {
        errors[LEFT] = error;
        assertEquals(LEFT, suspectedAfter(ENOUGH, turn));
        assertEquals(InspectionRate.FULL, inspection.rate());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.028, -0.028})
    void aSmallDifferenceIsNone(double error) {
        errors[LEFT] = error;
        assertEquals(-1, suspectedAfter(ENOUGH, 0));
    }

    @ParameterizedTest
    @CsvSource({"0.05, 0", "-0.05, 0", "0, 0.05", "0, -0.05"})
    void nothingIsSaidIfAnotherSensorSeesAChange(double ahead, double behind) {
        errors[LEFT] = 0.1;
        errors[FRONT_LEFT] = ahead;
        errors[REAR_LEFT] = behind;
        assertEquals(-1, suspectedAfter(ENOUGH, 0));
    }

    @Test
    void aSpikeIsNoJump() {
        errors[LEFT] = 0.1;
        suspectedAfter(3, 0);
        errors[LEFT] = 0;
        assertEquals(-1, suspectedAfter(ENOUGH, 0));
    }

    @Test
    void itTakesATenthOfASecond() {
        errors[LEFT] = 0.1;
        assertEquals(-1, suspectedAfter(9, 0));
        assertEquals(LEFT, suspectedAfter(2, 0));
        assertFalse(check.isDue(motion), "over");
    }

    @Test
    void aFastTurnEndsIt() {
        errors[LEFT] = 0.1;
        assertEquals(-1, suspectedAfter(ENOUGH, 0.03));
        assertFalse(check.isDue(motion), "over");
    }

    @Test
    void aSensorThatSeesNothingEndsIt() {
        errors[LEFT] = 0.1;
        errors[REAR_LEFT] = 1;
        assertEquals(-1, suspectedAfter(ENOUGH, 0));
        assertFalse(check.isDue(motion), "over");
    }
}
