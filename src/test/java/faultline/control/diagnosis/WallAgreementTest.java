package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WallAgreementTest {

    private static final double STEP = 0.003;
    private static final int FRONT_LEFT = 1;
    private static final int REAR_LEFT = 3;

    private final WallLine line = new WallLine(IntStream.range(0, 8)
            .mapToObj(i -> new InspectedSensor(
                    i, MountedCone.of(RobotSpec.DEFAULT.sensors().get(i), WallSide.LEFT)))
            .toArray(InspectedSensor[]::new));
    private final WallAgreement agreement = new WallAgreement();
    private double way;
    private double heading;

    /** Returns what the three read beside a wall at a distance from the robot's centre line. */
    private double[] beside(double distance) {
        double[] readings = new double[8];
        for (int place = 0; place < 3; place++) {
            int sensor = line.sensor(place).index();
            double[] none = new double[8];
            double[] one = new double[8];
            one[sensor] = 1;
            double least = line.aside(place, none);
            readings[sensor] = (distance - least) / (line.aside(place, one) - least);
        }
        return readings;
    }

    /** Drives along, with an error of a sensor, and returns the first finding. */
    private int drive(double metres, int sensor, double error, double turn) {
        for (double driven = 0; driven < metres; driven += STEP) {
            way += STEP;
            heading += turn;
            double[] readings = beside(0.4);
            readings[sensor] += error;
            int found = agreement.update(line, readings, way, heading);
            if (found != WallAgreement.NONE) {
                return line.sensor(found).index();
            }
        }
        return WallAgreement.NONE;
    }

    @ParameterizedTest
    @CsvSource({"1, 0.05", "1, -0.05", "2, 0.04", "2, -0.04", "3, 0.05", "3, -0.05"})
    void oneThatDiffersAlongAWallIsWrong(int sensor, double error) {
        assertEquals(sensor, drive(0.6, sensor, error, 0));
    }

    @ParameterizedTest
    @CsvSource({"1", "2", "3"})
    void smallDifferencesAreNone(int sensor) {
        assertEquals(WallAgreement.NONE, drive(3, sensor, 0.02, 0));
    }

    @Test
    void aThingAtTheWallPassesFromOneToTheNext() {
        assertEquals(WallAgreement.NONE, drive(0.3, FRONT_LEFT, -0.1, 0));
        assertEquals(WallAgreement.NONE, drive(0.3, 2, -0.1, 0));
        assertEquals(WallAgreement.NONE, drive(0.3, REAR_LEFT, -0.1, 0));
    }

    @Test
    void onABentPathNothingIsSaid() {
        assertEquals(WallAgreement.NONE, drive(3, 2, 0.05, 0.002));
    }

    @Test
    void whatIsNotSeenStartsAgain() {
        assertEquals(WallAgreement.NONE, drive(0.3, FRONT_LEFT, 0.05, 0));
        double[] readings = beside(0.4);
        readings[REAR_LEFT] = Reading.NOTHING;
        assertEquals(WallAgreement.NONE, agreement.update(line, readings, way, heading));
        assertEquals(WallAgreement.NONE, drive(0.3, FRONT_LEFT, 0.05, 0));
    }

    /** Drives along with an error of each of the three, and returns the first finding. */
    private int driveWith(double metres, double ahead, double facing, double behind) {
        for (double driven = 0; driven < metres; driven += STEP) {
            way += STEP;
            double[] readings = new double[8];
            double[] errors = {ahead, facing, behind};
            for (int place = 0; place < 3; place++) {
                readings[line.sensor(place).index()] =
                        beside(0.4 + errors[place])[line.sensor(place).index()];
            }
            int found = agreement.update(line, readings, way, heading);
            if (found != WallAgreement.NONE) {
                return line.sensor(found).index();
            }
        }
        return WallAgreement.NONE;
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0.031, 0, 2",
        "0, 0.029, 0, -1",
        "0, -0.031, 0, 2",
        "0, -0.029, 0, -1",
        "0.038, 0.07, 0, 2",
        "0.042, 0.08, 0, -1",
        "0.05, 0.011, 0, 1",
        "0.05, 0.013, 0, -1",
        "0, 0.011, 0.05, 3",
        "0, 0.013, 0.05, -1",
        "-0.05, 0, 0.011, 1"
    })
    void oneDiffersByMoreThanThreeCentimetresFromTwoThatAgree(double ahead, double facing, double behind, int wrong) {
        assertEquals(wrong, driveWith(3, ahead, facing, behind));
    }

    @Test
    void theDifferenceMustBeTheSameFromLegToLeg() {
        for (int leg = 0; leg < 12; leg++) {
            double error = leg % 2 == 0 ? 0.05 : 0.07;
            assertEquals(WallAgreement.NONE, driveWith(0.12, 0, error, 0), "leg " + leg);
        }
        assertEquals(2, driveWith(0.6, 0, 0.07, 0));
    }

    @Test
    void threeLegsAreNeeded() {
        assertEquals(WallAgreement.NONE, driveWith(0.35, 0, 0.05, 0));
        assertEquals(2, driveWith(0.03, 0, 0.05, 0));
    }

    @Test
    void onlyTheTurnWithinALegCounts() {
        heading = 2;
        agreement.update(line, new double[] {0, Reading.NOTHING, 0, 0, 0, 0, 0, 0}, way, heading);
        assertEquals(2, drive(0.6, 2, 0.05, 0.0011), "2.5 degrees in a leg");
        assertEquals(WallAgreement.NONE, drive(0.6, 2, 0.05, 0.0015), "3.4 degrees in a leg");
        assertEquals(2, drive(0.8, 2, 0.05, -0.0011));
        assertEquals(WallAgreement.NONE, drive(0.6, 2, 0.05, -0.0015));
    }

    @Test
    void legsBeforeARestartDoNotCount() {
        assertEquals(WallAgreement.NONE, drive(0.3, 2, 0.05, 0));
        agreement.restart(way, heading);
        assertEquals(WallAgreement.NONE, drive(0.3, 2, 0.05, 0));
        assertEquals(2, drive(0.2, 2, 0.05, 0));
    }

    /** Drives past a wall that all three see alike. */
    private void passStraightWall(double metres, double step) {
        for (double driven = 0; driven < metres; driven += Math.abs(step)) {
            way += step;
            agreement.update(line, beside(0.4), way, heading);
        }
    }

    /** Backwards, the sensor ahead has not seen the part of the wall that comes beside the robot. */
    @ParameterizedTest
    @CsvSource({"0.003, true", "-0.003, false"})
    void aWallIsStraightOnceTheSensorAheadHasSeenIt(double step, boolean straight) {
        passStraightWall(0.3, step);
        assertEquals(straight, agreement.isStraight());
    }

    @Test
    void aWallIsNoLongerStraightAsSoonAsASensorDiffers() {
        passStraightWall(0.3, STEP);
        assertEquals(WallAgreement.NONE, driveWith(0.03, -0.1, 0, 0));
        assertFalse(agreement.isStraight());
    }

    @Test
    void theSameSensorMustDifferInAllLegs() {
        for (int leg = 0; leg < 12; leg++) {
            double first = leg % 2 == 0 ? 0.05 : 0;
            assertEquals(WallAgreement.NONE, driveWith(0.12, first, 0.05 - first, 0), "leg " + leg);
        }
    }
}
