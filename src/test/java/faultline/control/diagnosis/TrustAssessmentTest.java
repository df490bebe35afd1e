package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class TrustAssessmentTest {

    private final InspectedSensor[] sensors = IntStream.range(0, 4)
            .mapToObj(i -> new InspectedSensor(i, new MountedCone(0, 0, i, 0.2, 0.8)))
            .toArray(InspectedSensor[]::new);
    private final TrustAssessment assessment = new TrustAssessment(sensors);

    /** Counts contradictions of the first sensor by the second and the third until it is not trusted. */
    private void contradictFirst(double time) {
        assessment.addContradiction(0, 0b0110, 10);
        assessment.assess(sensors[0], time);
        assertEquals(SensorFinding.CONTRADICTED, sensors[0].finding());
    }

    /** Counts contradictions of a sensor with itself until it is not trusted. */
    private void contradictItself(int sensor, double time) {
        assessment.addContradiction(sensor, sensors[sensor].bit(), 20);
        assessment.assess(sensors[sensor], time);
        assertEquals(SensorFinding.INCONSISTENT, sensors[sensor].finding());
    }

    @Test
    void aSensorIsTrustedAgainWhenAllThatContradictedItHaveLostTrust() {
        contradictFirst(1);
        contradictItself(1, 3);
        assertFalse(sensors[0].isTrusted(), "the third still contradicts it");
        contradictItself(2, 3);
        assertTrue(sensors[0].isTrusted());
        assertEquals(0b1001, assessment.trusted());
    }

    @Test
    void aContradictedSensorThatGivesNoAnswerIsNotTrustedAgain() {
        contradictFirst(1);
        assessment.distrust(sensors[0], SensorFinding.OFF, 3);
        contradictItself(1, 3);
        contradictItself(2, 3);
        assertFalse(sensors[0].isTrusted());
        assertEquals(0b1000, assessment.trusted());
    }

    @Test
    void aContradictedSensorThatAnswersAgainIsTrustedAgain() {
        contradictFirst(1);
        assessment.distrust(sensors[0], SensorFinding.OFF, 2);
        contradictItself(1, 3);
        contradictItself(2, 3);
        assertTrue(sensors[0].isTrusted());
    }
}
