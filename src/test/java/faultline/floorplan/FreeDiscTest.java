package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class FreeDiscTest {

    @Test
    void theMiddleOfAnEmptyMapIsClearest() {
        assertEquals(new FreeDisc(2, 2, 3), largest(grid(5, 5, new Random(0), 1)));
    }

    /** It is where the robot starts, so it must not depend on the order of a search. */
    @Test
    void ofDiscsOfTheSameSizeTheLowestIsTakenAndOfThoseTheLeftmost() {
        assertEquals(new FreeDisc(1, 1, 2), largest(grid(4, 4, new Random(0), 1)));
        assertEquals(new FreeDisc(1, 1, 2), largest(grid(7, 3, new Random(0), 1)));
    }

    @Test
    void itAgreesWithASearchThroughAllCells() {
        Random random = new Random(3);
        for (int trial = 0; trial < 300; trial++) {
            OccupancyGrid grid = grid(1 + random.nextInt(15), 1 + random.nextInt(15), random, random.nextDouble());
            FreeDisc found = largest(grid);
            double best = 0;
            for (int row = 0; row < grid.height(); row++) {
                for (int column = 0; column < grid.width(); column++) {
                    best = Math.max(best, clearance(grid, column, row));
                }
            }
            assertEquals(best, found.clearance());
            assertEquals(best, clearance(grid, found.column(), found.row()));
        }
    }

    @Test
    void specksThatAreDroppedAreFreeAndUnknownCellsAreNot() {
        CellState[] cells = new CellState[49];
        Arrays.fill(cells, CellState.FREE);
        cells[3 * 7 + 3] = CellState.OCCUPIED;
        OccupancyGrid speck = new OccupancyGrid(7, 7, cells);
        assertEquals(
                new FreeDisc(3, 3, 4),
                FreeDisc.largest(speck, speck.solidCells(false).withoutSpecks(2), false));
        cells[3 * 7 + 3] = CellState.UNKNOWN;
        assertEquals(2, Math.floor(largest(new OccupancyGrid(7, 7, cells)).clearance()));
    }

    private static FreeDisc largest(OccupancyGrid grid) {
        return FreeDisc.largest(grid, grid.solidCells(false), false);
    }

    private static double clearance(OccupancyGrid grid, int column, int row) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int r = -1; r <= grid.height(); r++) {
            for (int c = -1; c <= grid.width(); c++) {
                boolean inside = r >= 0 && c >= 0 && r < grid.height() && c < grid.width();
                if (!inside || grid.state(c, r) != CellState.FREE) {
                    nearest = Math.min(nearest, Math.sqrt((c - column) * (c - column) + (r - row) * (r - row)));
                }
            }
        }
        return nearest;
    }

    private static OccupancyGrid grid(int width, int height, Random random, double free) {
        CellState[] cells = new CellState[width * height];
        for (int i = 0; i < cells.length; i++) {
            boolean isFree = random.nextDouble() < free;
            cells[i] = isFree ? CellState.FREE : random.nextBoolean() ? CellState.OCCUPIED : CellState.UNKNOWN;
        }
        return new OccupancyGrid(width, height, cells);
    }
}
