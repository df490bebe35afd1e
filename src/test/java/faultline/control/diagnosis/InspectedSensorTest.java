package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class InspectedSensorTest {

    private final InspectedSensor sensor = new InspectedSensor(3, cone(0));

    private static MountedCone cone(double degrees) {
        return new MountedCone(0, 0, Math.toRadians(degrees), Math.toRadians(10), 0.8);
    }

    private void assertProbation(double seconds, double from) {
        assertFalse(sensor.hasServedProbation(from + seconds));
        assertTrue(sensor.hasServedProbation(from + seconds + 0.01));
    }

    @Test
    void eachFurtherFindingDoublesTheProbationUpTo48Seconds() {
        double time = 10;
        for (double probation : new double[] {3, 6, 12, 24, 48, 48}) {
            sensor.distrust(SensorFinding.NOISY, time);
            assertProbation(probation, time);
            sensor.trust(time + 60);
            assertTrue(sensor.isTrusted());
            assertEquals(time + 60, sensor.since());
            time += 100;
        }
        sensor.clearHistory();
        sensor.distrust(SensorFinding.NOISY, time);
        assertProbation(3, time);
    }

    @Test
    void aMisleadingSensorIsNotTriedAgainFor48Seconds() {
        sensor.distrust(SensorFinding.MISLEADING, 5);
        assertProbation(48, 5);
    }

    @Test
    void afterItsFirstFindingItKeepsItButTheProbationBeginsAgain() {
        sensor.distrust(SensorFinding.STUCK, 5);
        sensor.confirm(4);
        sensor.distrust(SensorFinding.OFF, 7);
        assertEquals(SensorFinding.STUCK, sensor.finding());
        assertEquals(7, sensor.since());
        assertEquals(0, sensor.confirmations());
        assertProbation(3, 7);
    }

    @Test
    void successiveDisagreementsAreCounted() {
        assertEquals(1, sensor.countDisagreement(true));
        assertEquals(2, sensor.countDisagreement(true));
        assertEquals(0, sensor.countDisagreement(false));
        assertEquals(1, sensor.countDisagreement(true));
        sensor.distrust(SensorFinding.CONTRADICTED, 1);
        assertEquals(1, sensor.countDisagreement(true), "a finding begins a new count");
    }

    @Test
    void confirmationsFade() {
        sensor.confirm(2);
        sensor.confirm(1.5);
        assertEquals(3.5, sensor.confirmations());
        sensor.fadeConfirmations(0.5);
        assertEquals(1.75, sensor.confirmations());
    }

    @ParameterizedTest
    @CsvSource({
        "0, false, false",
        "9, false, false",
        "11, true, false",
        "-11, true, false",
        "45, true, false",
        "-59, true, false",
        "-61, true, true",
        "-90, true, true",
        "-179, true, true",
        "90, true, false",
        "149, true, false",
        "151, true, true",
        "180, true, true"
    })
    void thoseThatLookBackOrAwayFromTheWallLookAway(double bearing, boolean aside, boolean away) {
        InspectedSensor mounted = new InspectedSensor(0, cone(bearing));
        assertEquals(aside, mounted.looksAside());
        assertEquals(away, mounted.looksAway());
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "90, 1", "-90, 0.35"})
    void itsConeMovesSidewaysByRollingAndByTurning(double bearing, double share) {
        RobotSpec prompt = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));
        DeadReckoning reckoning = new DeadReckoning();
        InspectedSensor mounted = new InspectedSensor(0, cone(bearing));
        assertEquals(Double.POSITIVE_INFINITY, mounted.movedSinceMark(reckoning));
        reckoning.advance(prompt, 1, 2, 0.01, 50);
        mounted.mark(reckoning);
        assertEquals(0, mounted.movedSinceMark(reckoning));
        reckoning.advance(prompt, 3, 3, 0.01, 10);
        assertEquals(share * 0.03, mounted.movedSinceMark(reckoning), 1e-12);
        reckoning.advance(prompt, -1, 1, 0.01, 10);
        assertEquals(share * 0.03 + 0.24 * 0.1 * 0.2 / 0.18, mounted.movedSinceMark(reckoning), 1e-12);
    }

    @Test
    void aMarkRepresentsTheInspectionsSinceTheLastOne() {
        DeadReckoning reckoning = new DeadReckoning();
        sensor.countInspection();
        sensor.countInspection();
        assertEquals(2, sensor.inspections());
        assertEquals(2, sensor.mark(reckoning));
        sensor.countInspection();
        assertEquals(1, sensor.mark(reckoning));
        assertEquals(3, sensor.inspections());
    }

    @Test
    void everySecondRowIsMarkedInTurn() {
        assertEquals(EvidenceGrid.RowParity.EVEN, sensor.nextRows());
        assertEquals(EvidenceGrid.RowParity.ODD, sensor.nextRows());
        assertEquals(EvidenceGrid.RowParity.EVEN, sensor.nextRows());
    }

    @Test
    void anotherConeReplacesTheTableOfDirections() {
        ConeTable table = sensor.table();
        sensor.refit(cone(0));
        assertSame(table, sensor.table());
        sensor.refit(cone(-100));
        assertNotSame(table, sensor.table());
        assertTrue(sensor.looksAway());
        assertEquals(cone(-100), sensor.cone());
        assertEquals(3, sensor.index());
        assertEquals(8, sensor.bit());
    }

    @Test
    void jumpsAndMissedSurfacesAreRemembered() {
        assertTrue(sensor.blindAt() < 0);
        sensor.jump(4);
        PredictedSurface surface = new PredictedSurface(1, 2, 1, 0);
        sensor.missSurface(surface, 5);
        sensor.setUnseenSample(6);
        assertEquals(4, sensor.jumpedAt());
        assertEquals(5, sensor.blindAt());
        assertSame(surface, sensor.missed());
        assertEquals(6, sensor.unseenSample());
    }
}
