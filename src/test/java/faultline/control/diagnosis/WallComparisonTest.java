package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The sensors on the wall's side are compared at equal distances of the path. */
class WallComparisonTest {

    private static final double DT = 0.01;
    private static final double VOLTS = 3;
    private static final int LEFT = RobotSpec.DEFAULT.indexOf("left");
    private static final int FRONT_LEFT = RobotSpec.DEFAULT.indexOf("front-left");
    private static final int RIGHT = RobotSpec.DEFAULT.indexOf("right");

    private final RobotSpec robot = RobotSpec.DEFAULT;
    private final MotionAccumulator motion = new MotionAccumulator();
    private final DeadReckoning reckoning = new DeadReckoning();
    private final InspectedSensor[] sensors = IntStream.range(0, 8)
            .mapToObj(i -> new InspectedSensor(i, MountedCone.of(robot.sensors().get(i), WallSide.LEFT)))
            .toArray(InspectedSensor[]::new);
    private final WallLine line = new WallLine(sensors);
    private final TrustAssessment assessment = new TrustAssessment(sensors.length);
    private final SensorInspection inspection = new SensorInspection(
            sensors,
            assessment,
            new EvidenceGrid(sensors.length + 1),
            reckoning,
            new MotionClock(),
            motion,
            new HealthReport(robot));
    private final JumpCheck jumpCheck = new JumpCheck(motion, assessment, inspection);
    private final WallComparison check = new WallComparison(motion, reckoning, assessment, inspection, jumpCheck);

    @BeforeEach
    void refit() {
        check.refit(line);
        inspection.refit(0.1);
    }

    /** Returns what the sensors read beside a wall at a distance from the robot's centre line. */
    private double[] beside(double distance) {
        double[] readings = new double[sensors.length];
        Arrays.fill(readings, Reading.NOTHING);
        double[] ones = new double[sensors.length];
        Arrays.fill(ones, 1);
        for (int place = 0; place < 3; place++) {
            double least = line.aside(place, new double[sensors.length]);
            readings[line.sensor(place).index()] = (distance - least) / (line.aside(place, ones) - least);
        }
        return readings;
    }

    /** Drives straight on by the motor model on a path that bends, and returns the number of samples. */
    private int drive(double metres, double bend) {
        return drive(metres, bend, 0, 0);
    }

    /** The same with an error of a sensor. */
    private int drive(double metres, double bend, int sensor, double error) {
        int count = 0;
        double start = motion.netDistance();
        while (motion.netDistance() < start + metres) {
            reckoning.advance(robot, VOLTS, VOLTS, DT, 1);
            motion.advance(reckoning.rolled(), reckoning.turned(), DT);
            if (check.isDue(motion)) {
                double driven = motion.netDistance() - start;
                double[] readings = beside(0.4 - bend * driven * driven / 2);
                readings[sensor] += error;
                check.run(readings, 1);
                count++;
            }
        }
        return count;
    }

    @Test
    void sensorsAreComparedAfterEachFifteenMillimetres() {
        drive(1, 0);
        double step = reckoning.rolled();
        int count = drive(3, 0);
        assertTrue(count <= 3 / 0.015 + 1 && count >= 3 / (0.015 + step) - 1, count + " in 3 m");
    }

    @Test
    void aRobotThatTurnsOnTheSpotIsNotSampled() {
        assertFalse(check.isDue(motion), "at the start");
        drive(0.1, 0);
        check.run(beside(0.4), 1);
        motion.advance(0, 0.5, DT);
        assertFalse(check.isDue(motion));
    }

    /** The path bends towards the wall, so that the reading is a parabola. */
    @Test
    void aBentPathCorrectsTheDeadReckoning() {
        drive(2, 0.15);
        double before = reckoning.heading();
        drive(0.2, 0);
        assertEquals(0.15, (reckoning.heading() - before) / 0.2, 0.05);
    }

    @Test
    void theCorrectionRemainsAsLongAsThePathBends() {
        drive(1.2, 0.15);
        drive(1.2, 0.15);
        for (int i = 0; i < 5; i++) {
            double before = reckoning.heading();
            drive(1.2, 0.15);
            assertEquals(0.15, (reckoning.heading() - before) / 1.2, 0.03, "part " + i);
        }
    }

    @Test
    void aStraightPathCorrectsNothing() {
        drive(3, 0);
        assertEquals(0, reckoning.heading());
    }

    private boolean isSuspected(int sensor) {
        return assessment.evidence(sensor) > 0;
    }

    @Test
    void aSensorThatDiffersOverThreeLegsDriftsAndBringsTheFullRate() {
        letRateFall();
        drive(0.3, 0, LEFT, 0.05);
        assertFalse(isSuspected(LEFT), "after two legs");
        assertEquals(InspectionRate.STRAIGHT, inspection.rate());
        drive(0.15, 0, LEFT, 0.05);
        assertTrue(isSuspected(LEFT), "after three legs");
        assertEquals(InspectionRate.FULL, inspection.rate());
    }

    @Test
    void legsBeforeAJumpOfASensorOnTheWallsSideDoNotCount() {
        drive(0.3, 0, LEFT, 0.05);
        check.jump(sensors[FRONT_LEFT]);
        drive(0.3, 0, LEFT, 0.05);
        assertFalse(isSuspected(LEFT));
    }

    @Test
    void legsBeforeAJumpOfAnotherSensorCount() {
        drive(0.3, 0, LEFT, 0.05);
        check.jump(sensors[RIGHT]);
        drive(0.15, 0, LEFT, 0.05);
        assertTrue(isSuspected(LEFT));
    }

    @Test
    void onlyAJumpOfASensorOnTheWallsSideBringsTheFullRate() {
        letRateFall();
        check.jump(sensors[RIGHT]);
        assertEquals(InspectionRate.STRAIGHT, inspection.rate());
        check.jump(sensors[FRONT_LEFT]);
        assertEquals(InspectionRate.FULL, inspection.rate());
    }

    @Test
    void aJumpOfTheSensorThatFacesAStraightWallIsChecked() {
        drive(0.3, 0);
        check.jump(sensors[LEFT]);
        assertTrue(jumpCheck.isDue(motion));
    }

    @Test
    void aJumpOfAnotherSensorIsNotChecked() {
        drive(0.3, 0);
        check.jump(sensors[FRONT_LEFT]);
        assertFalse(jumpCheck.isDue(motion));
    }

    @Test
    void aJumpIsNotCheckedBeforeTheWallWasAheadOfTheRobot() {
        drive(0.2, 0);
        check.jump(sensors[LEFT]);
        assertFalse(jumpCheck.isDue(motion));
    }

    @Test
    void aJumpIsNotCheckedWhereTheSensorAheadHasSeenSomething() {
        drive(0.3, 0);
        drive(0.1, 0, FRONT_LEFT, -0.1);
        check.jump(sensors[LEFT]);
        assertFalse(jumpCheck.isDue(motion));
    }

    @ParameterizedTest
    @CsvSource({
        "front-left, 0.19, FULL",
        "front-right, 0.19, FULL",
        "front-left, 0.21, STRAIGHT",
        "front, 0.1, STRAIGHT",
        "left, 0.1, STRAIGHT",
        "rear-right, 0.1, STRAIGHT"
    })
    void onlyASurfaceNearADiagonalFrontSensorBringsTheFullRate(String sensor, double reading, InspectionRate expected) {
        letRateFall();
        double[] readings = new double[sensors.length];
        Arrays.fill(readings, Reading.NOTHING);
        readings[robot.indexOf(sensor)] = reading;
        check.run(readings, 1);
        assertEquals(expected, inspection.rate());
    }

    private void letRateFall() {
        inspection.run(beside(0.4), 1);
        assertEquals(InspectionRate.STRAIGHT, inspection.rate());
    }

    @ParameterizedTest
    @CsvSource({"0.014, false", "0.016, true", "-0.014, false", "-0.016, true"})
    void sensorsAreComparedForwardsAndBackwards(double rolled, boolean due) {
        drive(0.1, 0);
        check.run(beside(0.4), 1);
        motion.advance(rolled, 0, DT);
        assertEquals(due, check.isDue(motion));
    }
}
