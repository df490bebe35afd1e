package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.control.diagnosis.TrustAssessment.TrustRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TrustAssessmentTest {

    private final TrustAssessment assessment = new TrustAssessment(4);

    /** Counts contradictions of the first sensor by the second and the third until it is not trusted. */
    private void contradictFirst(double time) {
        assessment.addContradiction(0, 0b0110, 10);
        assessment.assess(0, time);
        assertEquals(SensorFinding.CONTRADICTED, assessment.finding(0));
    }

    /** Counts contradictions of a sensor with itself until it is not trusted. */
    private void contradictItself(int sensor, double time) {
        assessment.addContradiction(sensor, 1 << sensor, 20);
        assessment.assess(sensor, time);
        assertEquals(SensorFinding.INCONSISTENT, assessment.finding(sensor));
    }

    @Test
    void aSensorIsTrustedAgainWhenAllThatContradictedItHaveLostTrust() {
        contradictFirst(1);
        contradictItself(1, 3);
        assertFalse(assessment.isTrusted(0), "the third still contradicts it");
        contradictItself(2, 3);
        assertTrue(assessment.isTrusted(0));
        assertEquals(0b1001, assessment.trusted());
    }

    @Test
    void aContradictedSensorThatGivesNoAnswerIsNotTrustedAgain() {
        contradictFirst(1);
        assessment.distrust(0, SensorFinding.OFF, 3);
        contradictItself(1, 3);
        contradictItself(2, 3);
        assertFalse(assessment.isTrusted(0));
        assertEquals(0b1000, assessment.trusted());
    }

    @Test
    void aContradictedSensorThatAnswersAgainIsTrustedAgain() {
        contradictFirst(1);
        assessment.distrust(0, SensorFinding.OFF, 2);
        contradictItself(1, 3);
        contradictItself(2, 3);
        assertTrue(assessment.isTrusted(0));
    }

    @ParameterizedTest
    @CsvSource({"6.99, true", "7.01, false"})
    void onlyASensorContradictedInTheLastSixSecondsIsTrustedAgain(double time, boolean trusted) {
        contradictFirst(1);
        contradictItself(1, time);
        contradictItself(2, time);
        assertEquals(trusted, assessment.isTrusted(0));
    }

    @Test
    void aSensorThatMissedNothingIsTriedAgainAsSoonAsAfterItsFirstFinding() {
        assessment.distrust(0, SensorFinding.BLIND, 0);
        assessment.restore(0, 1);
        assessment.distrust(0, SensorFinding.STUCK, 1);
        assessment.addConfirmation(0, 13);
        assessment.assess(0, 3.99);
        assertFalse(assessment.isTrusted(0));
        assessment.assess(0, 4.01);
        assertTrue(assessment.isTrusted(0));
    }

    @ParameterizedTest
    @CsvSource({"14, true", "14.1, false"})
    void aContradictionByAllTogetherCountsHalf(double weight, boolean trusted) {
        assessment.addContradiction(0, 0, weight);
        assessment.assess(0, 1);
        assertEquals(trusted, assessment.isTrusted(0));
    }

    @Test
    void ofSensorsAboveTheThresholdOnlyTheOneWithTheGreatestCountIsDistrusted() {
        assessment.addContradiction(0, 0b0110, 10);
        assessment.addContradiction(1, 0b1100, 10);
        assessment.assess(0, 1);
        assertTrue(assessment.isTrusted(0), "the second is contradicted by three");
        assessment.assess(1, 1);
        assertEquals(0b1101, assessment.trusted());
    }

    @ParameterizedTest
    @CsvSource({"1, CONTRADICTED", "11.9, CONTRADICTED", "12.1, INCONSISTENT"})
    void theGreaterPartOfTheCountDecidesWhoContradictedIt(double byItself, SensorFinding expected) {
        assessment.addContradiction(0, 0b0001, byItself);
        assessment.addContradiction(0, 0b0110, 10);
        assessment.assess(0, 1);
        assertEquals(expected, assessment.finding(0));
    }

    @Test
    void aSensorThatMissesASurfaceButIsContradictedMoreByOthersIsNotBlind() {
        assessment.addMissedSurface(0, 1);
        contradictFirst(1);
    }

    @ParameterizedTest
    @CsvSource({"0, true", "0.6, false"})
    void aSensorThatOneOtherContradictsMayBeRightUnlessItContradictsItself(double byItself, boolean mayBeRight) {
        assessment.addContradiction(0, 0b0001, byItself);
        contradictFirst(1);
        assertFalse(assessment.mayBeRight(0), "two others contradict it");
        contradictItself(1, 2);
        assertEquals(mayBeRight, assessment.mayBeRight(0));
    }

    private static void assertProbation(double seconds, double from, TrustRecord sensor) {
        assertFalse(sensor.hasServedProbation(from + seconds));
        assertTrue(sensor.hasServedProbation(from + seconds + 0.01));
    }

    @Test
    void eachFurtherFindingDoublesTheProbationUpTo48Seconds() {
        TrustRecord sensor = new TrustRecord();
        double time = 10;
        for (double probation : new double[] {3, 6, 12, 24, 48, 48}) {
            sensor.distrust(SensorFinding.NOISY, time);
            assertProbation(probation, time, sensor);
            sensor.trust(time + 60);
            assertTrue(sensor.isTrusted());
            time += 100;
        }
        sensor.clearHistory();
        sensor.distrust(SensorFinding.NOISY, time);
        assertProbation(3, time, sensor);
    }

    @Test
    void aMisleadingSensorIsNotTriedAgainFor48Seconds() {
        TrustRecord sensor = new TrustRecord();
        sensor.distrust(SensorFinding.MISLEADING, 5);
        assertProbation(48, 5, sensor);
    }

    @Test
    void afterItsFirstFindingItKeepsItButTheProbationBeginsAgain() {
        assessment.distrust(0, SensorFinding.STUCK, 5);
        assessment.distrust(0, SensorFinding.OFF, 7);
        assertEquals(SensorFinding.STUCK, assessment.finding(0));
        assessment.addConfirmation(0, 13);
        assessment.assess(0, 10);
        assertFalse(assessment.isTrusted(0));
        assessment.assess(0, 10.01);
        assertTrue(assessment.isTrusted(0));
    }

    @Test
    void confirmationsFadeAndAFurtherFindingEndsThem() {
        assessment.distrust(0, SensorFinding.STUCK, 0);
        assessment.addConfirmation(0, 20);
        assessment.fade(0, 0.5);
        assessment.assess(0, 4);
        assertFalse(assessment.isTrusted(0), "10 are left");
        assessment.addConfirmation(0, 3);
        assessment.distrust(0, SensorFinding.STUCK, 4);
        assessment.assess(0, 8);
        assertFalse(assessment.isTrusted(0), "none is left");
        assessment.addConfirmation(0, 12.5);
        assessment.assess(0, 8);
        assertTrue(assessment.isTrusted(0));
    }

    /** Lets two sensors contradict only each other, and returns after how many inspections one is not trusted. */
    private int inspectionsOfDisagreement() {
        for (int inspections = 1; inspections < 100; inspections++) {
            assessment.addContradiction(0, 0b0010, 10);
            assessment.assess(0, 20);
            if (!assessment.isTrusted(0)) {
                return inspections;
            }
        }
        return 100;
    }

    @Test
    void ofTwoThatContradictOnlyEachOtherOneLosesTrustAfter25Inspections() {
        assertEquals(26, inspectionsOfDisagreement());
        assertEquals(SensorFinding.CONTRADICTED, assessment.finding(0));
    }

    @Test
    void onlySuccessiveInspectionsCount() {
        for (int i = 0; i < 25; i++) {
            assessment.addContradiction(0, 0b0010, 10);
            assessment.assess(0, 20);
        }
        assessment.fade(0, 0);
        assessment.assess(0, 20);
        assertEquals(26, inspectionsOfDisagreement());
    }

    @Test
    void theOneThatOthersConfirmMoreKeepsTrust() {
        assessment.addConfirmation(0, 1);
        assertEquals(100, inspectionsOfDisagreement());
    }

    @Test
    void theOneThatJumpedUpToFourSecondsAgoLosesTrustAfter3Inspections() {
        assessment.addConfirmation(0, 1);
        assessment.addJump(0, 16.01);
        assertEquals(4, inspectionsOfDisagreement());
    }

    @Test
    void anEarlierJumpDoesNotCount() {
        assessment.addJump(0, 16);
        assertEquals(26, inspectionsOfDisagreement());
    }

    @Test
    void aSensorThatMissesTwoSurfacesIsBlind() {
        assessment.addMissedSurface(2, 5);
        assessment.assess(2, 5);
        assertTrue(assessment.isTrusted(2));
        assessment.addMissedSurface(2, 5.1);
        assessment.assess(2, 5.1);
        assertEquals(SensorFinding.BLIND, assessment.finding(2));
        assertTrue(assessment.hasFoundBlind(5.1));
        assertFalse(assessment.hasFoundBlind(5));
        assessment.restore(2, 6);
        assertTrue(assessment.allTrusted());
    }
}
