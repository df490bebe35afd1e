package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A sensor at the origin measures 0.4 m; the arc is 0.14 m long. */
class ArcCheckTest {

    private static final double HALF = Math.toRadians(10);
    private static final double READING = 0.4;
    private static final int ASKED = 0b1110;

    private final EvidenceGrid grid = new EvidenceGrid(4);
    private final ArcCheck check = new ArcCheck(grid, 1);
    private final InspectedSensor sensor = new InspectedSensor(0, new MountedCone(0, 0, 0, HALF, 0.8));

    private void measure(double axis) {
        sensor.measurements().add(0, 0, axis, Math.cos(axis), Math.sin(axis), READING, 0);
    }

    private void seeFree(int source, double axis, double side, int moment) {
        // A disc that covers one half of the arc with the margin beside it, or all of it if the side is 0.
        double direction = axis + side * 0.8 * HALF;
        double radius = side == 0 ? 0.15 : 0.08;
        grid.markDisc(source, READING * Math.cos(direction), READING * Math.sin(direction), radius, moment);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 2.5, -0.7, -2})
    void thoseThatSawAllOfTheArcFreeContradictIt(double axis) {
        measure(axis);
        assertEquals(ArcCheck.POSSIBLE, check.contradicting(sensor, 0, 5, ASKED));
        seeFree(1, axis, 0, 5);
        seeFree(3, axis, 0, 6);
        assertEquals(0b1010, check.contradicting(sensor, 0, 5, ASKED));
        assertEquals(0b1000, check.contradicting(sensor, 0, 6, ASKED));
        assertEquals(0b0010, check.contradicting(sensor, 0, 5, 0b0010));
        assertEquals(ArcCheck.POSSIBLE, check.contradicting(sensor, 0, 7, ASKED));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 2.5, -0.7, -2})
    void aPartThatNobodySawFreeIsEnough(double axis) {
        measure(axis);
        seeFree(1, axis, 1, 5);
        assertEquals(ArcCheck.POSSIBLE, check.contradicting(sensor, 0, 5, ASKED));
        assertTrue(check.unseenSample(0) < ConeTable.SAMPLES / 2, "sample " + check.unseenSample(0));
        seeFree(2, axis, -1, 5);
        assertEquals(0, check.contradicting(sensor, 0, 5, ASKED));
    }

    @Test
    void theTestBeginsWhereTheLastOneEnded() {
        measure(0);
        seeFree(1, 0, -1, 5);
        assertEquals(ArcCheck.POSSIBLE, check.contradicting(sensor, 0, 5, ASKED));
        int unseen = check.unseenSample(0);
        assertTrue(unseen > ConeTable.SAMPLES / 2, "sample " + unseen);
        assertEquals(ArcCheck.POSSIBLE, check.contradicting(sensor, 0, 5, ASKED));
        assertEquals(unseen, check.unseenSample(0));
        seeFree(1, 0, 1, 5);
        assertEquals(0b0010, check.contradicting(sensor, 0, 5, ASKED));
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "0, -1", "1, 1", "1, -1", "2.5, 1", "2.5, -1", "-0.7, 1", "-0.7, -1", "-2, 1", "-2, -1"})
    void theArcReachesTwoCentimetresBeyondTheCone(double axis, int side) {
        measure(axis);
        // All of the cone, and the margin on the other side only.
        seeSector(axis);
        seeSector(axis - side * 0.1);
        double border = axis + side * HALF;
        int column = EvidenceGrid.cellOf(READING * Math.cos(border) - side * 0.025 * Math.sin(border));
        int row = EvidenceGrid.cellOf(READING * Math.sin(border) + side * 0.025 * Math.cos(border));
        assertEquals(0, grid.freeBy(column, row, 5, ASKED));
        assertEquals(ArcCheck.POSSIBLE, check.contradicting(sensor, 0, 5, ASKED));
        seeSector(axis + side * 0.1);
        assertEquals(0b0010, check.contradicting(sensor, 0, 5, ASKED));
    }

    private void seeSector(double axis) {
        ConeTable table = new ConeTable(new MountedCone(0, 0, 0, HALF, 1));
        grid.markSector(1, 0, 0, Math.cos(axis), Math.sin(axis), table, 0.5, 5, EvidenceGrid.RowParity.ALL);
    }

    @Test
    void anEarlierMeasurementIsTestedAtItsOwnPlace() {
        measure(0);
        measure(2);
        seeFree(1, 0, 0, 5);
        assertEquals(ArcCheck.POSSIBLE, check.contradicting(sensor, 0, 5, ASKED));
        assertEquals(0b0010, check.contradicting(sensor, 1, 5, ASKED));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 2.5, -0.7, -2})
    void anotherSensorConfirmsAnySampleOfTheArc(double axis) {
        for (int i = 0; i < ConeTable.SAMPLES; i++) {
            double direction = axis + HALF * (2.0 * i / (ConeTable.SAMPLES - 1) - 1);
            measure(axis);
            int column = EvidenceGrid.cellOf(READING * Math.cos(direction));
            int row = EvidenceGrid.cellOf(READING * Math.sin(direction));
            int moment = 10 * i + 10;
            assertFalse(check.confirm(sensor, moment, moment, ASKED));
            grid.markHit(2, column, row, moment);
            assertFalse(check.confirm(sensor, moment, moment, 0b1010));
            assertFalse(check.confirm(sensor, moment, moment + 1, ASKED));
            assertTrue(check.confirm(sensor, moment, moment, ASKED), "sample " + i);
            assertTrue(grid.isHit(column, row, moment, 1), "its own evidence, sample " + i);
        }
    }
}
