package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
}
