package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EvidenceGridTest {

    @Test
    void aSectorMarksTheCellsWhoseCentresLieInIt() {
        SplittableRandom random = new SplittableRandom(3);
        for (int trial = 0; trial < 200; trial++) {
            EvidenceGrid grid = new EvidenceGrid(1);
            double x = random.nextDouble(-3, 3);
            double y = random.nextDouble(-3, 3);
            double axis = random.nextDouble(-Math.PI, Math.PI);
            double half = random.nextDouble(0.05, 1.2);
            double radius = random.nextDouble(0.1, 0.8);
            assertSectorIsMarked(grid, x, y, axis, half, radius);
        }
    }

    private static void assertSectorIsMarked(
            EvidenceGrid grid, double x, double y, double axis, double half, double radius) {
        ConeTable table = new ConeTable(new MountedCone(0, 0, 0, half, 1));
        grid.markSector(0, x, y, Math.cos(axis), Math.sin(axis), table, radius, 5, EvidenceGrid.RowParity.ALL);
        for (int row = EvidenceGrid.cellOf(y - radius - 0.1); row < EvidenceGrid.cellOf(y + radius + 0.1); row++) {
            for (int column = EvidenceGrid.cellOf(x - radius - 0.1);
                    column < EvidenceGrid.cellOf(x + radius + 0.1);
                    column++) {
                double dx = (column + 0.5) * EvidenceGrid.CELL - x;
                double dy = (row + 0.5) * EvidenceGrid.CELL - y;
                double off = Math.abs(Math.IEEEremainder(Math.atan2(dy, dx) - axis, 2 * Math.PI));
                double slack = Math.min(Math.abs(off - half), Math.abs(Math.hypot(dx, dy) - radius));
                if (slack > 1e-9) {
                    boolean inside = off < half && Math.hypot(dx, dy) < radius;
                    assertEquals(inside ? 1 : 0, grid.freeBy(column, row, 5, 1), "radius " + radius);
                }
            }
        }
    }

    /** As far as a robot that keeps far from its wall uses its sensors. */
    @Test
    void sectorsInALargeGridMayHaveMoreRowsThanASmallOne() {
        for (double radius = 1.2; radius < 2.8; radius += 0.1) {
            EvidenceGrid grid = new EvidenceGrid(1);
            grid.resize(256);
            assertSectorIsMarked(grid, 0.01, 0.02, 0, 1.5, radius);
        }
    }

    /** Beyond 26 843 km, columns exceed the greatest integer, and beyond 53 687 km rows do. */
    @ParameterizedTest
    @CsvSource({"26843545.5, 0", "-26843545.7, 0", "1e10, 0", "0, 53687091", "0, 1e10", "-1e10, -1e10"})
    void marksVeryFarFromTheStartEnd(double x, double y) {
        EvidenceGrid grid = new EvidenceGrid(1);
        ConeTable table = new ConeTable(new MountedCone(0, 0, 0, 0.3, 1));
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            for (EvidenceGrid.RowParity rows : EvidenceGrid.RowParity.values()) {
                grid.markSector(0, x, y, 1, 0, table, 0.5, 5, rows);
                grid.markSector(0, x, y, -1, 0, table, 0.5, 5, rows);
            }
            grid.markDisc(0, x, y, 0.2, 5);
        });
    }

    @Test
    void theLatestMomentsInARowAreThoseOfItsCells() {
        SplittableRandom random = new SplittableRandom(8);
        EvidenceGrid grid = new EvidenceGrid(3);
        for (int moment = 1; moment <= 400; moment++) {
            int source = random.nextInt(3);
            grid.markHit(source, random.nextInt(-60, 60), random.nextInt(-60, 60), moment);
            grid.markDisc(source, random.nextDouble(-1.4, 1.4), random.nextDouble(-1.4, 1.4), 0.06, moment);
        }
        int[] free = new int[72];
        int[] hit = new int[72];
        for (int trial = 0; trial < 2000; trial++) {
            int column = random.nextInt(-200, 200);
            int row = random.nextInt(-200, 200);
            int since = random.nextInt(1, 420);
            int asked = random.nextInt(8);
            boolean anyFree = grid.findLastFree(column, row, since, asked, free);
            boolean anyHit = grid.findLastHit(column, row, since, asked, hit);
            for (int i = 0; i < free.length; i++) {
                boolean isFree = grid.freeBy(column + i, row, since, asked) != 0;
                boolean isHit = grid.isHit(column + i, row, since, asked);
                assertEquals(isFree, free[i] >= since, "trial " + trial);
                assertEquals(isHit, hit[i] >= since, "trial " + trial);
                assertTrue(anyFree || !isFree);
                assertTrue(anyHit || !isHit);
            }
        }
    }

    @Test
    void whatIsOlderThanAskedForDoesNotCount() {
        EvidenceGrid grid = new EvidenceGrid(2);
        grid.markHit(1, 0, 0, 100);
        assertTrue(grid.isHit(0, 0, 100, 3));
        assertFalse(grid.isHit(0, 0, 101, 3));
        assertFalse(grid.isHit(0, 0, 100, 1));
    }
}
