package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.control.WallSide;
import faultline.geometry.Angles;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SpinComparisonTest {

    private static final double DT = 0.01;
    private static final double WALL = 0.45;
    private static final int FRONT = 0;
    private static final RobotSpec ROBOT = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));

    private final DeadReckoning reckoning = new DeadReckoning();
    private final InspectedSensor[] sensors = IntStream.range(0, 8)
            .mapToObj(i -> new InspectedSensor(i, MountedCone.of(ROBOT.sensors().get(i), WallSide.LEFT)))
            .toArray(InspectedSensor[]::new);
    private final TrustAssessment assessment = new TrustAssessment(sensors.length);
    private final SpinComparison comparison = new SpinComparison(sensors, reckoning, assessment);
    private final MotionAccumulator motion = new MotionAccumulator();
    private final double[] errors = new double[8];

    /** Returns the distance to a wall whose foot is in a direction, seen from the start, radians. */
    private double reading(MountedCone cone, double foot) {
        double relative = Angles.normalize(foot - reckoning.heading());
        double ahead = WALL
                - (reckoning.x() * Math.cos(foot) + reckoning.y() * Math.sin(foot))
                - (cone.x() * Math.cos(relative) + cone.y() * Math.sin(relative));
        double beyond = Math.abs(Angles.normalize(relative - cone.bearing())) - cone.half();
        double distance = beyond < 0 ? ahead : beyond > 1.4 ? Reading.NOTHING : ahead / Math.cos(beyond);
        return distance < cone.range() ? distance : Reading.NOTHING;
    }

    /** Drives in an inner corner, and returns whether a spin has ended. */
    private boolean drive(double leftVolts, double rightVolts, int ticks, double footAhead) {
        boolean ended = false;
        for (int i = 0; i < ticks; i++) {
            reckoning.advance(ROBOT, leftVolts, rightVolts, DT, 1);
            motion.advance(reckoning.rolled(), reckoning.turned(), DT);
            ended |= comparison.isDue(motion) && comparison.update(readings(footAhead));
        }
        return ended;
    }

    private double[] readings(double footAhead) {
        double[] readings = new double[8];
        for (InspectedSensor sensor : sensors) {
            readings[sensor.index()] = errors[sensor.index()]
                    + Math.min(reading(sensor.cone(), Math.PI / 2), reading(sensor.cone(), footAhead));
        }
        return readings;
    }

    /** Spins right by 120 degrees, and returns what is wrong. */
    private int spin(double footAhead) {
        assertFalse(drive(0.942, -0.942, 200, footAhead));
        assertTrue(drive(3, 3, 10, footAhead));
        return comparison.wrongAhead();
    }

    @ParameterizedTest
    @CsvSource({"0, 0.035", "0, -0.035", "-25, 0.035", "-25, -0.035", "40, 0.035", "40, -0.035"})
    void anErrorOfTheSensorAheadIsFoundInACorner(double footAhead, double error) {
        errors[FRONT] = error;
        assertEquals(FRONT, spin(Math.toRadians(footAhead)));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "-25, 0", "40, 0", "0, 0.015", "0, -0.015", "40, 0.015", "0, 0.3"})
    void aSmallErrorOrAnotherSurfaceIsNotFound(double footAhead, double error) {
        errors[FRONT] = error;
        assertEquals(SpinComparison.NONE, spin(Math.toRadians(footAhead)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7})
    void theSensorAheadIsNotBlamedForAnother(int other) {
        errors[other] = 0.05;
        assertEquals(SpinComparison.NONE, spin(0));
    }

    /** The sensor at its right still agrees with the sensor ahead. */
    @Test
    void twoOthersWithTheSameErrorDoNotOutvoteAThird() {
        errors[1] = 0.05;
        errors[2] = 0.05;
        assertEquals(SpinComparison.NONE, spin(0));
    }

    /** All differ by more than 12 mm from each other, and by more than 25 mm from the sensor ahead. */
    @Test
    void withoutTwoSensorsThatAgreeNoneIsFound() {
        for (int i = 1; i < 8; i++) {
            errors[i] = 0.015 * (i - 3);
        }
        errors[FRONT] = 0.09;
        assertEquals(SpinComparison.NONE, spin(0));
    }

    @Test
    void anErrorIsFoundAlthoughAFewDirectionsAreWithoutIt() {
        errors[FRONT] = 0.035;
        drive(0.942, -0.942, 80, 0);
        errors[FRONT] = 0;
        drive(0.942, -0.942, 20, 0);
        errors[FRONT] = 0.035;
        drive(0.942, -0.942, 100, 0);
        assertTrue(drive(3, 3, 10, 0));
        assertEquals(FRONT, comparison.wrongAhead());
    }

    @Test
    void anArcIsNoSpin() {
        assertFalse(drive(2.5, 3.5, 100, 0));
    }

    /** Half the speed at the full turn rate, as in ROUND while the wall is out of sight. */
    @Test
    void aTightBendIsNoSpin() {
        assertFalse(drive(0.558, 2.442, 200, 0));
        assertFalse(drive(3, 3, 10, 0));
    }

    /** A spin of 30 degrees; the next sensor is 45 degrees apart. */
    @Test
    void inAShortSpinNoTwoSensorsLookInTheSameDirections() {
        errors[FRONT] = 0.05;
        assertFalse(drive(0.942, -0.942, 50, 0));
        assertTrue(drive(3, 3, 10, 0));
        assertEquals(SpinComparison.NONE, comparison.wrongAhead());
    }

    @Test
    void theLastTwoTurnsOfALongSpinAreCompared() {
        errors[FRONT] = 0.05;
        assertFalse(drive(0.942, -0.942, 1000, 0));
        errors[FRONT] = 0;
        assertFalse(drive(0.942, -0.942, 1500, 0));
        assertTrue(drive(3, 3, 10, 0));
        assertEquals(SpinComparison.NONE, comparison.wrongAhead());
    }

    @Test
    void aSecondSpinForgetsTheFirst() {
        errors[FRONT] = 0.05;
        assertEquals(FRONT, spin(0));
        errors[FRONT] = 0;
        drive(-3, -3, 10, 0);
        drive(-0.942, 0.942, 200, 0);
        drive(3, 3, 10, 0);
        assertEquals(SpinComparison.NONE, comparison.wrongAhead());
    }

    /** The first spin has shown the error to sensors that do not see the walls of the second. */
    @Test
    void aShortSecondSpinForgetsTheFirst() {
        errors[FRONT] = 0.05;
        assertEquals(FRONT, spin(0));
        assertFalse(drive(0.942, -0.942, 50, 0));
        assertTrue(drive(3, 3, 10, 0));
        assertEquals(SpinComparison.NONE, comparison.wrongAhead());
    }

    @ParameterizedTest
    @CsvSource({"10, 0", "11, -1"})
    void onlySensorsWithEqualConesAreCompared(double half, int wrong) {
        MountedCone cone = sensors[FRONT].cone();
        sensors[FRONT].refit(new MountedCone(cone.x(), cone.y(), cone.bearing(), Math.toRadians(half), cone.range()));
        errors[FRONT] = 0.05;
        assertEquals(wrong, spin(0));
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aSpinIsNotComparedIfASensorIsNotTrusted(boolean trusted) {
        if (!trusted) {
            assessment.distrust(7, SensorFinding.STUCK, 0);
        }
        errors[FRONT] = 0.05;
        drive(0.942, -0.942, 200, 0);
        reckoning.advance(ROBOT, 3, 3, DT, 10);
        comparison.run(readings(0), 0);
        assertEquals(trusted, assessment.evidence(FRONT) > 1);
    }

    /** The nearest place of a wall beyond a wide cone is at its border, on which the mounting has less influence. */
    @ParameterizedTest
    @CsvSource({
        "-25, 0, -1",
        "-25, 0.02, -1",
        "-25, 0.035, 0",
        "-25, -0.035, 0",
        "40, 0, -1",
        "40, 0.02, -1",
        "40, 0.035, 0"
    })
    void aSensorFarFromTheCentreMeasuresTheSameDistances(double footAhead, double error, int wrong) {
        for (InspectedSensor sensor : sensors) {
            MountedCone cone = sensor.cone();
            double x = sensor.index() == FRONT ? 0.3 : cone.x();
            sensor.refit(new MountedCone(x, cone.y(), cone.bearing(), Math.toRadians(20), cone.range()));
        }
        errors[FRONT] = error;
        assertEquals(wrong, spin(Math.toRadians(footAhead)));
    }
}
