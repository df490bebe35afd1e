package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The sensors are inspected less often as long as nothing is suspicious, and count for as much over time. */
class InspectionRateTest {

    private static final double DT = 0.01;
    private static final double VOLTS = 6;
    /** The number of ticks after which an inspection is due at any rate. */
    private static final int LONG = 80;

    private final RobotSpec robot = RobotSpec.DEFAULT;
    private final InspectedSensor[] sensors =
            new InspectedSensor[robot.sensors().size()];
    private final double[] readings = new double[sensors.length];
    private final DeadReckoning reckoning = new DeadReckoning();
    private final MotionAccumulator motion = new MotionAccumulator();
    private TrustAssessment assessment;
    private SensorInspection inspection;

    @BeforeEach
    void mount() {
        for (int i = 0; i < sensors.length; i++) {
            sensors[i] = new InspectedSensor(i, MountedCone.of(robot.sensors().get(i), WallSide.LEFT));
        }
        Arrays.fill(readings, Reading.NOTHING);
        assessment = new TrustAssessment(sensors.length);
        inspection = new SensorInspection(
                sensors,
                assessment,
                new EvidenceGrid(sensors.length + 1),
                reckoning,
                new MotionClock(),
                motion,
                new HealthReport(robot));
        inspection.refit(0.1);
    }

    private InspectionRate rateAfter(double leftVolts, double rightVolts) {
        reckoning.advance(robot, leftVolts, rightVolts, DT, LONG);
        motion.advance(reckoning.rolled(), reckoning.turned(), LONG * DT);
        while (inspection.isDue(motion)) {
            inspection.run(readings, LONG);
        }
        return inspection.rate();
    }

    @Test
    void theFirstInspectionIsAtTheFullRate() {
        assertEquals(InspectionRate.FULL, inspection.rate());
    }

    @Test
    void aRobotInOpenSpaceIsInspectedLessOftenOnStraightPartsThanInTurns() {
        assertEquals(InspectionRate.STRAIGHT, rateAfter(VOLTS, VOLTS));
        assertEquals(InspectionRate.REDUCED, rateAfter(VOLTS, -VOLTS));
        assertTrue(InspectionRate.STRAIGHT.interval() > InspectionRate.REDUCED.interval());
    }

    @Test
    void aSensorThatIsNotTrustedBringsTheFullRate() {
        assessment.distrust(robot.indexOf("rear"), SensorFinding.STUCK, 0);
        assertEquals(InspectionRate.FULL, rateAfter(VOLTS, VOLTS));
    }

    @Test
    void aContradictionBringsTheFullRate() {
        assessment.addContradiction(0, 0b110, 1);
        assertEquals(InspectionRate.FULL, rateAfter(VOLTS, VOLTS));
    }

    @Test
    void aNearSurfaceThatMayCrossThePathBringsTheFullRate() {
        readings[robot.indexOf("front-right")] = 0.15;
        assertEquals(InspectionRate.FULL, rateAfter(VOLTS, VOLTS));
        readings[robot.indexOf("front-right")] = 0.25;
        assertEquals(InspectionRate.REDUCED, rateAfter(VOLTS, VOLTS));
    }

    @Test
    void aSurfaceThatOnlyTheDiagonalSensorAwayFromTheWallSeesBringsTheReducedRate() {
        readings[robot.indexOf("front-right")] = 0.7;
        assertEquals(InspectionRate.REDUCED, rateAfter(VOLTS, VOLTS));
        readings[robot.indexOf("front")] = 0.7;
        assertEquals(InspectionRate.STRAIGHT, rateAfter(VOLTS, VOLTS));
        readings[robot.indexOf("front-right")] = Reading.NOTHING;
        readings[robot.indexOf("front-left")] = 0.7;
        assertEquals(InspectionRate.STRAIGHT, rateAfter(VOLTS, VOLTS));
    }

    /** Returns the time until the next inspection. */
    private double untilDue() {
        double start = motion.time();
        while (!inspection.isDue(motion)) {
            motion.advance(0, 0, DT);
        }
        return motion.time() - start;
    }

    @Test
    void attentionBringsAnInspectionSoonAndKeepsTheRateOfStraightPathsAwayForHalfASecond() {
        assertEquals(InspectionRate.STRAIGHT, rateAfter(VOLTS, VOLTS));
        inspection.attend();
        double start = motion.time();
        assertEquals(InspectionRate.FULL, inspection.rate());
        double interval = DT * sensors.length;
        assertEquals(interval, untilDue(), 1e-9);
        inspection.run(readings, 1);
        double reduced = interval * InspectionRate.REDUCED.interval();
        while (inspection.rate() != InspectionRate.STRAIGHT) {
            assertEquals(InspectionRate.REDUCED, inspection.rate());
            assertEquals(reduced, untilDue(), 1e-9);
            inspection.run(readings, 1);
        }
        assertTrue(motion.time() - start > 0.5 - DT / 2, "not before");
        assertEquals(0.5, motion.time() - start, reduced);
    }

    @Test
    void hasteLastsForOneInspection() {
        assertEquals(InspectionRate.STRAIGHT, rateAfter(VOLTS, VOLTS));
        inspection.hasten();
        assertEquals(DT * sensors.length, untilDue(), 1e-9);
        inspection.run(readings, 1);
        assertEquals(InspectionRate.STRAIGHT, inspection.rate());
    }

    @Test
    void attentionDoesNotDelayAnInspectionThatIsDue() {
        assertEquals(InspectionRate.STRAIGHT, rateAfter(VOLTS, VOLTS));
        for (double left = untilDueWhenStraight(); left > 0.02; left -= DT) {
            motion.advance(0, 0, DT);
        }
        inspection.attend();
        assertTrue(untilDue() < 0.03);
    }

    private double untilDueWhenStraight() {
        return DT * sensors.length * InspectionRate.STRAIGHT.interval();
    }

    @Test
    void theNextInspectionIsDueAfterTheTimeOfItsRate() {
        assertTrue(inspection.isDue(motion), "the first");
        for (InspectionRate rate : new InspectionRate[] {InspectionRate.STRAIGHT, InspectionRate.REDUCED}) {
            assertEquals(rate, rateAfter(VOLTS, rate == InspectionRate.STRAIGHT ? VOLTS : -VOLTS));
            int ticks = 0;
            while (!inspection.isDue(motion)) {
                motion.advance(0, 0, DT);
                ticks++;
            }
            assertEquals(rate.interval() * sensors.length, ticks);
        }
    }

    @Test
    void countsFadeByTheSameShareOverTime() {
        for (InspectionRate rate : InspectionRate.values()) {
            assertEquals(
                    StrictMath.pow(InspectionRate.FULL.fade(), 8),
                    StrictMath.pow(rate.fade(), 8.0 / rate.interval()),
                    1e-12);
        }
    }
}
