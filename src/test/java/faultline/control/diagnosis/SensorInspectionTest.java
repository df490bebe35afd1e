package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** When sensors are inspected, in which order, and which evidence counts. The robot starts at the origin. */
class SensorInspectionTest {

    private static final int FIRST = 0;
    private static final int SECOND = 1;
    private static final double RANGE = 2;

    private final MotionAccumulator motion = new MotionAccumulator();
    private final MotionClock clock = new MotionClock();
    private final DeadReckoning reckoning = new DeadReckoning();
    private TrustAssessment assessment;
    private EvidenceGrid grid;
    private SensorInspection inspection;
    private double[] readings;

    /** Creates the inspection of sensors that see nothing yet. */
    private void inspect(MountedCone... cones) {
        InspectedSensor[] sensors = new InspectedSensor[cones.length];
        readings = new double[cones.length];
        for (int i = 0; i < cones.length; i++) {
            sensors[i] = new InspectedSensor(i, cones[i]);
            readings[i] = Reading.NOTHING;
        }
        assessment = new TrustAssessment(cones.length);
        grid = new EvidenceGrid(cones.length + 1);
        HealthReport report = new HealthReport(RobotSpec.DEFAULT);
        inspection = new SensorInspection(sensors, assessment, grid, reckoning, clock, motion, report);
        inspection.refit(0.1);
    }

    private static MountedCone cone(double y, double degrees) {
        return new MountedCone(0, y, Math.toRadians(degrees), Math.toRadians(10), RANGE);
    }

    private void inspectAfter(double seconds) {
        motion.advance(0, 0, seconds);
        inspection.run(readings, 1);
    }

    /** Advances the motion clock; a robot that rolls a metre takes 1000 ticks. */
    private void advanceClock(double ticks) {
        clock.advance(ticks / 1000, 0, 0);
    }

    private boolean isFreeByBody(double x) {
        int body = 1 << readings.length;
        return grid.freeBy(EvidenceGrid.cellOf(x), 0, clock.moment(), body) != 0;
    }

    /** A larger disc would cover the whole grid, which wraps, and so contradict every measurement. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.2, true", "0.3, 0.4, false", "2, 1.2, true", "2, 1.3, false"})
    void theBodyOfAWideRobotIsFreeOnlyAsFarAsSensorsAreUsed(double radius, double x, boolean free) {
        inspect(cone(0, 180));
        inspection.refit(radius);
        inspectAfter(1);
        assertEquals(free, isFreeByBody(x));
    }

    /**
     * What an earlier sensor saw free counts at once. The order does not depend on that of the list, so a robot and its
     * mirror image come to the same findings.
     */
    @ParameterizedTest
    @CsvSource({"-45, 45", "-170, 170", "-10, 10", "-1, 0", "-10, -20"})
    void sensorsAreInspectedFromTheFrontTowardsTheWallAndThenFromBehind(double later, double earlier) {
        inspect(narrowCone(later), wideCone(earlier));
        readings[FIRST] = 0.3;
        readings[SECOND] = 0.53;
        inspectAfter(1);
        assertTrue(assessment.evidence(FIRST) > 0, "the one that saw the place free was before it");

        inspect(narrowCone(earlier), wideCone(later));
        readings[FIRST] = 0.3;
        readings[SECOND] = 0.53;
        inspectAfter(1);
        assertEquals(0, assessment.evidence(FIRST), "it was not yet seen free");
    }

    /** Returns a cone that looks at the robot's centre from 0.3 m away, as in no real robot. */
    private static MountedCone coneTowards(double degrees, double half) {
        double bearing = Math.toRadians(degrees);
        return new MountedCone(
                -0.3 * Math.cos(bearing), -0.3 * Math.sin(bearing), bearing, Math.toRadians(half), RANGE);
    }

    private static MountedCone narrowCone(double degrees) {
        return coneTowards(degrees, 5);
    }

    private static MountedCone wideCone(double degrees) {
        return coneTowards(degrees, 40);
    }

    /** Eight sensors are inspected every 0.08 s while a surface is near. */
    @ParameterizedTest
    @CsvSource({"0.01", "0.03", "0.05"})
    void ticksOfAnyLengthGiveTheSameNumberOfInspections(double dt) {
        MountedCone[] cones = new MountedCone[8];
        for (int i = 0; i < cones.length; i++) {
            cones[i] = cone(0, 45 * i - 180);
        }
        inspect(cones);
        readings[5] = 0.15;
        int count = 0;
        for (int i = 0; i * dt < 24; i++) {
            motion.advance(0, 0, dt);
            if (inspection.isDue(motion)) {
                inspection.run(readings, i);
                count++;
            }
        }
        assertEquals(300, count, 2);
    }

    /** The sum of many ticks is not exact. */
    @Test
    void noInspectionIsPutOffByRounding() {
        inspect(cone(0, 45), cone(0, 0));
        readings[FIRST] = 0.15;
        for (int i = 1; i <= 1000; i++) {
            motion.advance(0, 0, 0.01);
            boolean due = inspection.isDue(motion);
            assertEquals(i == 1 || i % 2 == 0, due, "tick " + i);
            if (due) {
                inspection.run(readings, i);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1.2, 1.25, true", "1.3, 1.25, false", "1.3, 2, true"})
    void whatIsMeasuredBeyondTheReachIsNotUsed(double reading, double wanted, boolean used) {
        inspect(cone(0, 0), cone(0, 180));
        inspection.setReach(EvidenceReach.of(wanted == 2 ? 2 : 0.5));
        grid.markDisc(SECOND, reading, 0, 0.3, clock.moment());
        readings[FIRST] = reading;
        inspectAfter(1);
        assertEquals(used, assessment.evidence(FIRST) > 0);
    }

    /** Beyond it, places share a cell of the grid. */
    @ParameterizedTest
    @CsvSource({"1.15, true", "1.3, false"})
    void aSensorThatSeesFartherThanTheReachFindsNothingFreeBeyondIt(double x, boolean free) {
        inspect(cone(0, 0), cone(0, 180));
        readings[FIRST] = 1.9;
        inspectAfter(1);
        assertEquals(free, grid.freeBy(EvidenceGrid.cellOf(x), 0, clock.moment(), 1 << FIRST) != 0);
    }

    @ParameterizedTest
    @CsvSource({"690, true", "710, false"})
    void evidenceCountsForSevenTenthsOfAMetre(double ticks, boolean counts) {
        inspect(cone(0, 0), cone(0, 180));
        grid.markDisc(SECOND, 0.4, 0, 0.15, clock.moment());
        advanceClock(ticks);
        readings[FIRST] = 0.4;
        inspectAfter(1);
        assertEquals(counts, assessment.evidence(FIRST) > 0);
    }

    /**
     * A measurement is tested once more against what was seen since, but not against what was seen with it: that
     * counted when it was new.
     */
    @ParameterizedTest
    @CsvSource({
        "0, 10, 10, true",
        "0, 10, 9, true",
        "0, 10, 1, true",
        "0, 10, 0, false",
        "0.5, 10, 0, false",
        "0, 1, 1, false",
        "0, 690, 690, true",
        "0, 710, 710, false"
    })
    void aMeasurementIsTestedAgainByLaterEvidence(double start, double passed, double seenAfter, boolean counts) {
        inspect(cone(0, 0), cone(0, 180));
        advanceClock(start);
        inspectAfter(1);
        readings[FIRST] = 0.4;
        inspectAfter(1);
        // It sees something near now, so that it does not contradict itself.
        readings[FIRST] = 0.2;
        advanceClock(seenAfter);
        grid.markDisc(SECOND, 0.4, 0, 0.12, clock.moment());
        advanceClock(passed - seenAfter);
        inspectAfter(1);
        assertEquals(counts, assessment.evidence(FIRST) > 0);
    }

    /** Whatever the number of measurements so far, so that none is missed. */
    @ParameterizedTest
    @CsvSource({"4, false", "5, true", "6, false", "12, true", "24, true"})
    void whileSomethingIsSuspiciousEveryMeasurementIsTestedAgainThreeTimes(int inspections, boolean counts) {
        for (int before = 1; before <= 3; before++) {
            inspect(cone(0, 0), cone(0, 180), cone(0, -90));
            assessment.distrust(2, SensorFinding.STUCK, 0);
            for (int i = 0; i < before; i++) {
                inspectAfter(0.03);
            }
            readings[FIRST] = 0.4;
            inspectAfter(0.03);
            readings[FIRST] = 0.2;
            advanceClock(2);
            grid.markDisc(SECOND, 0.4, 0, 0.12, clock.moment());
            for (int i = 1; i < inspections; i++) {
                inspectAfter(0.03);
            }
            assessment.fade(FIRST, 0);
            inspectAfter(0.03);
            assertEquals(counts, assessment.evidence(FIRST) > 0, before + " before");
        }
    }

    private void contradict() {
        assessment.addContradiction(FIRST, 1 << SECOND, 5);
    }

    @ParameterizedTest
    @CsvSource({"0.95, FULL", "1.05, STRAIGHT"})
    void aContradictionBringsTheFullRateForASecond(double seconds, InspectionRate expected) {
        inspect(cone(0, 0), cone(0, 180));
        inspectAfter(1);
        assertEquals(InspectionRate.STRAIGHT, inspection.rate());
        contradict();
        inspectAfter(1);
        assertEquals(InspectionRate.FULL, inspection.rate());
        assessment.fade(FIRST, 0);
        assessment.fade(SECOND, 0);
        inspectAfter(seconds);
        assertEquals(expected, inspection.rate());
    }

    @ParameterizedTest
    @CsvSource({"0.45, STRAIGHT", "0.55, REDUCED", "-0.45, STRAIGHT", "-0.55, REDUCED"})
    void aTurnReducesTheTimeBetweenInspections(double rate, InspectionRate expected) {
        inspect(cone(0, 0));
        motion.advance(0, 0.01 * rate, 0.01);
        inspection.run(readings, 1);
        assertEquals(expected, inspection.rate());
    }

    @Test
    void aRestingBodyIsAddedAgainWhileSomethingIsSuspicious() {
        inspect(cone(0, 0), cone(0, 180));
        inspectAfter(1);
        assertTrue(isFreeByBody(0));
        advanceClock(1);
        inspectAfter(1);
        assertFalse(isFreeByBody(0), "nothing is suspicious");
        contradict();
        inspectAfter(1);
        advanceClock(1);
        inspectAfter(0.1);
        assertTrue(isFreeByBody(0));
    }

    /** A robot without inertia has the speed of its voltage at once. */
    private void drive(double leftVolts, double rightVolts, double seconds) {
        RobotSpec prompt = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));
        reckoning.advance(prompt, leftVolts, rightVolts, seconds, 1);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "-1, -1", "0.7, 1", "1, 0.7", "-0.5, 0.5"})
    void aSurfaceIsAtTheReadingFromTheMountedSensorWhereverTheRobotIs(double leftVolts, double rightVolts) {
        MountedCone cone = new MountedCone(0.3, 0.2, Math.toRadians(30), Math.toRadians(1), RANGE);
        inspect(cone, cone(0, 180));
        drive(leftVolts, rightVolts, 4);
        readings[FIRST] = 0.4;
        inspectAfter(1);
        Pose pose = new Pose(reckoning.x(), reckoning.y(), reckoning.heading());
        double ahead = cone.x() + 0.4 * Math.cos(cone.bearing());
        double aside = cone.y() + 0.4 * Math.sin(cone.bearing());
        Vector2 seen = pose.toParent(new Vector2(ahead, aside));
        int column = EvidenceGrid.cellOf(seen.x());
        int row = EvidenceGrid.cellOf(seen.y());
        assertTrue(grid.isHit(column, row, clock.moment(), 1 << FIRST));
    }

    @Test
    void aContradictionThatDoesNotRecurIsForgotten() {
        inspect(cone(0, 0), cone(0, 180));
        contradict();
        for (int i = 0; i < 1000; i++) {
            motion.advance(0, 0, 0.01);
            if (inspection.isDue(motion)) {
                inspection.run(readings, i);
            }
        }
        assertEquals(0, assessment.evidence(FIRST));
    }

    /** Beside something near that is only seen diagonally, as {@link MissedSurfacesTest} has it. */
    @ParameterizedTest
    @CsvSource({"0.25, false", "0.1, true"})
    void aFrontSensorThatMissesWhatIsNearerThanTheWallIsBlindUntilThePlaceIsSeenFree(double wanted, boolean trusted) {
        inspect(cone(0, 0), cone(0, -45), cone(0, 180));
        drive(3, 3, 1e-6);
        inspection.setWantedDistance(wanted);
        readings[SECOND] = 0.1;
        for (int i = 0; i < 5; i++) {
            inspectAfter(0.01);
        }
        assertEquals(trusted ? SensorFinding.NONE : SensorFinding.BLIND, assessment.finding(FIRST));
        grid.markDisc(2, 0.2, 0, 0.2, clock.moment());
        inspectAfter(0.01);
        assertEquals(SensorFinding.NONE, assessment.finding(FIRST));
    }
}
