package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class HealthReportTest {

    private final InspectedSensor[] sensors = IntStream.range(0, 8)
            .mapToObj(i -> new InspectedSensor(i, new MountedCone(0, 0, i, 0.2, 0.8)))
            .toArray(InspectedSensor[]::new);
    private final TrustAssessment assessment = new TrustAssessment(sensors.length);
    private final HealthReport report = new HealthReport(RobotSpec.DEFAULT);

    private void assertTrust(SensorTrust trust, double evidence, double share) {
        assessment.fade(0, share / assessment.evidence(0));
        report.update(0, assessment, 1);
        SensorHealth health = report.all().get(0);
        assertEquals(trust, health.trust(), "at " + share + " of the threshold");
        assertEquals(evidence, health.evidence());
    }

    @Test
    void aSensorIsSuspectedFromHalfOfTheThresholdDownToFourTenths() {
        assessment.addContradiction(0, 2, 4.9);
        assertTrust(SensorTrust.TRUSTED, 0.4, 0.49);
        assessment.addContradiction(0, 2, 1);
        assertTrust(SensorTrust.SUSPECTED, 0.5, 0.51);
        assertTrust(SensorTrust.SUSPECTED, 0.4, 0.41);
        assertTrust(SensorTrust.TRUSTED, 0.3, 0.39);
        assertTrust(SensorTrust.TRUSTED, 0.2, 0.29);
    }

    /** The first sensor is contradicted only by two that are inspected, and lose trust, after it. */
    @Test
    void aSensorIsReportedAsTrustedInTheInspectionThatRestoresTheTrustInIt() {
        MotionAccumulator motion = new MotionAccumulator();
        SensorInspection inspection = new SensorInspection(
                sensors,
                assessment,
                new EvidenceGrid(sensors.length + 1),
                new DeadReckoning(),
                new MotionClock(),
                motion,
                report);
        inspection.refit(0.1);
        double[] readings = new double[sensors.length];
        Arrays.fill(readings, Reading.NOTHING);

        assessment.addContradiction(0, 0b0110, 10);
        motion.advance(0, 0, 1);
        inspection.run(readings, 100);
        assertEquals(SensorFinding.CONTRADICTED, report.all().get(0).finding());

        assessment.addContradiction(1, 0b0010, 20);
        assessment.addContradiction(2, 0b0100, 15);
        motion.advance(0, 0, 1);
        inspection.run(readings, 200);
        assertFalse(assessment.isTrusted(1) || assessment.isTrusted(2));
        assertTrue(assessment.isTrusted(0));
        SensorHealth restored = report.all().get(0);
        assertEquals(SensorTrust.TRUSTED, restored.trust());
        assertEquals(200, restored.sinceTick());
    }

    @Test
    void moreEvidenceThanTheThresholdIsReportedAsAllOfIt() {
        assessment.addContradiction(0, 0b0110, 6);
        assertTrust(SensorTrust.SUSPECTED, 1, 1.25);
    }
}
