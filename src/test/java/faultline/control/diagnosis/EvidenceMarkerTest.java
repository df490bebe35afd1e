package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.diagnosis.EvidenceMarker.EvidenceSchedule;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EvidenceMarkerTest {

    private static MountedCone cone(double degrees) {
        return new MountedCone(0, 0, Math.toRadians(degrees), Math.toRadians(10), 0.8);
    }

    @ParameterizedTest
    @CsvSource({
        "0, false",
        "45, false",
        "-59, false",
        "-61, true",
        "-90, true",
        "-179, true",
        "90, false",
        "149, false",
        "151, true",
        "180, true"
    })
    void thoseThatLookBackOrAwayFromTheWallLookAway(double bearing, boolean away) {
        assertEquals(away, EvidenceMarker.looksAway(cone(bearing)));
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "90, 1", "-90, 0.35"})
    void itsConeMovesSidewaysByRollingAndByTurning(double bearing, double share) {
        RobotSpec prompt = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));
        DeadReckoning reckoning = new DeadReckoning();
        EvidenceSchedule schedule = new EvidenceSchedule();
        assertEquals(Double.POSITIVE_INFINITY, schedule.moved(cone(bearing), reckoning));
        reckoning.advance(prompt, 1, 2, 0.01, 50);
        schedule.mark(reckoning, 1);
        assertEquals(0, schedule.moved(cone(bearing), reckoning));
        reckoning.advance(prompt, 3, 3, 0.01, 10);
        assertEquals(share * 0.03, schedule.moved(cone(bearing), reckoning), 1e-12);
        reckoning.advance(prompt, -1, 1, 0.01, 10);
        assertEquals(share * 0.03 + 0.24 * 0.1 * 0.2 / 0.18, schedule.moved(cone(bearing), reckoning), 1e-12);
    }

    @Test
    void aMarkRepresentsTheMeasurementsSinceTheLastOne() {
        DeadReckoning reckoning = new DeadReckoning();
        EvidenceSchedule schedule = new EvidenceSchedule();
        assertEquals(2, schedule.mark(reckoning, 2));
        assertEquals(1, schedule.mark(reckoning, 3));
        assertEquals(4, schedule.mark(reckoning, 7));
    }

    @Test
    void everySecondRowIsMarkedInTurn() {
        EvidenceSchedule schedule = new EvidenceSchedule();
        assertEquals(EvidenceGrid.RowParity.EVEN, schedule.nextRows());
        assertEquals(EvidenceGrid.RowParity.ODD, schedule.nextRows());
        assertEquals(EvidenceGrid.RowParity.EVEN, schedule.nextRows());
    }
}
