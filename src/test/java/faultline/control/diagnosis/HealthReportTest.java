package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.robot.RobotSpec;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class HealthReportTest {

    private final InspectedSensor[] sensors = IntStream.range(0, 8)
            .mapToObj(i -> new InspectedSensor(i, new MountedCone(0, 0, i, 0.2, 0.8)))
            .toArray(InspectedSensor[]::new);
    private final TrustAssessment assessment = new TrustAssessment(sensors);
    private final HealthReport report = new HealthReport(RobotSpec.DEFAULT);

    private void assertTrust(SensorTrust trust, double evidence, double share) {
        assessment.fade(sensors[0], share / assessment.evidence(0));
        report.update(sensors[0], assessment, 1);
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
}
