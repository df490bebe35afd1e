package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class FreeDiscTest {

    @Test
    void theMiddleOfAnEmptyMapIsClearest() {
        assertEquals(new FreeDisc(2.5, 2.5, 3), aboutCell(grid(5, 5, new Random(0), 1)));
    }

    /** It is where the robot starts, so it must not depend on the order of a search. */
    @Test
    void ofDiscsOfTheSameSizeTheLowestIsTakenAndOfThoseTheLeftmost() {
        assertEquals(new FreeDisc(1.5, 1.5, 2), aboutCell(grid(4, 4, new Random(0), 1)));
        assertEquals(new FreeDisc(1.5, 1.5, 2), aboutCell(grid(7, 3, new Random(0), 1)));
    }

    @Test
    void itAgreesWithASearchThroughAllCells() {
        Random random = new Random(3);
        for (int trial = 0; trial < 300; trial++) {
            OccupancyGrid grid = grid(1 + random.nextInt(15), 1 + random.nextInt(15), random, random.nextDouble());
            FreeDisc found = aboutCell(grid);
            double best = 0;
            for (int row = 0; row < grid.height(); row++) {
                for (int column = 0; column < grid.width(); column++) {
                    best = Math.max(best, clearance(grid, column, row));
                }
            }
            assertEquals(best, found.clearance());
            assertEquals(best, clearance(grid, (int) found.x(), (int) found.y()));
        }
    }

    @Test
    void aCornerHasTheRadiusOfTheFreeDiscAboutIt() {
        assertEquals(new FreeDisc(1, 1, 1), aboutCorner(grid(9, 2, new Random(0), 1)));
        assertEquals(new FreeDisc(2, 2, 2), aboutCorner(grid(4, 4, new Random(0), 1)));
        assertEquals(0, aboutCorner(grid(1, 7, new Random(0), 1)).clearance());
        Random random = new Random(4);
        for (int trial = 0; trial < 300; trial++) {
            OccupancyGrid grid = grid(1 + random.nextInt(15), 1 + random.nextInt(15), random, random.nextDouble());
            double best = 0;
            for (int y = 1; y < grid.height(); y++) {
                for (int x = 1; x < grid.width(); x++) {
                    best = Math.max(best, radius(grid, x, y));
                }
            }
            FreeDisc found = aboutCorner(grid);
            assertEquals(best, found.clearance());
            assertEquals(best, radius(grid, (int) found.x(), (int) found.y()));
        }
    }

    /** Returns the distance from a corner of cells to the nearest cell that is not free. */
    private static double radius(OccupancyGrid grid, int x, int y) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int r = -1; r <= grid.height(); r++) {
            for (int c = -1; c <= grid.width(); c++) {
                if (!isFree(grid, c, r)) {
                    double dx = Math.max(0, Math.max(c - x, x - c - 1));
                    double dy = Math.max(0, Math.max(r - y, y - r - 1));
                    nearest = Math.min(nearest, Math.sqrt(dx * dx + dy * dy));
                }
            }
        }
        return nearest;
    }

    private static boolean isFree(OccupancyGrid grid, int column, int row) {
        boolean inside = row >= 0 && column >= 0 && row < grid.height() && column < grid.width();
        return inside && grid.state(column, row) == CellState.FREE;
    }

    @Test
    void specksThatAreDroppedAreFreeAndUnknownCellsAreNot() {
        CellState[] cells = new CellState[49];
        Arrays.fill(cells, CellState.FREE);
        cells[3 * 7 + 3] = CellState.OCCUPIED;
        OccupancyGrid speck = new OccupancyGrid(7, 7, cells);
        assertEquals(
                new FreeDisc(3.5, 3.5, 4),
                FreeDisc.aboutCell(speck, speck.solidCells(false).withoutSpecks(2), false));
        cells[3 * 7 + 3] = CellState.UNKNOWN;
        assertEquals(2, Math.floor(aboutCell(new OccupancyGrid(7, 7, cells)).clearance()));
    }

    private static FreeDisc aboutCell(OccupancyGrid grid) {
        return FreeDisc.aboutCell(grid, grid.solidCells(false), false);
    }

    private static FreeDisc aboutCorner(OccupancyGrid grid) {
        return FreeDisc.aboutCorner(grid, grid.solidCells(false), false);
    }

    private static double clearance(OccupancyGrid grid, int column, int row) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int r = -1; r <= grid.height(); r++) {
            for (int c = -1; c <= grid.width(); c++) {
                if (!isFree(grid, c, r)) {
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
