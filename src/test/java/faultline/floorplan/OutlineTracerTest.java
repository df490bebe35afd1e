package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Outlines give the cells back for any bitmap. */
class OutlineTracerTest {

    /** Returns twice the enclosed area in cells, negative for the outline of a hole. */
    private static long doubledArea(GridRing ring) {
        long sum = 0;
        for (int i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            sum += (long) ring.column(j) * ring.row(i) - (long) ring.column(i) * ring.row(j);
        }
        return sum;
    }

    @Test
    void aSingleCellIsASquareWithTheSolidOnTheLeft() {
        List<GridRing> rings = OutlineTracer.trace(cells("...", ".#.", "..."));
        assertEquals(1, rings.size());
        assertEquals(4, rings.get(0).size());
        assertEquals(2, doubledArea(rings.get(0)));
        assertEquals(1, rings.get(0).column(0));
        assertEquals(1, rings.get(0).row(0));
    }

    @Test
    void aHoleIsARingOfNegativeArea() {
        List<GridRing> rings = OutlineTracer.trace(cells("###", "#.#", "###"));
        assertEquals(
                List.of(18L, -2L),
                rings.stream().map(OutlineTracerTest::doubledArea).toList());
    }

    @Test
    void cellsThatTouchAtACornerHaveRingsOfTheirOwn() {
        assertEquals(2, OutlineTracer.trace(cells("#.", ".#")).size());
        assertEquals(2, OutlineTracer.trace(cells(".#", "#.")).size());
    }

    @Test
    void aStraightWallHasOnlyItsCorners() {
        assertEquals(4, OutlineTracer.trace(cells("#####")).get(0).size());
    }

    @Test
    void noSolidCellHasNoOutline() {
        assertEquals(List.of(), OutlineTracer.trace(cells("..", "..")));
    }

    @Test
    void scanningTheOutlinesOfRandomBitmapsGivesThemBack() {
        Random random = new Random(1);
        for (int trial = 0; trial < 2000; trial++) {
            SolidCells cells = randomCells(random, 1 + random.nextInt(12), 1 + random.nextInt(12), random.nextDouble());
            List<GridRing> rings = OutlineTracer.trace(cells);
            assertEquals(cells, scan(rings, cells.width(), cells.height()));
            assertEquals(
                    2L * cells.count(),
                    rings.stream().mapToLong(OutlineTracerTest::doubledArea).sum());
            rings.forEach(OutlineTracerTest::requireCornersOnly);
        }
    }

    private static void requireCornersOnly(GridRing ring) {
        for (int i = 0; i < ring.size(); i++) {
            int before = (i + ring.size() - 1) % ring.size();
            int after = (i + 1) % ring.size();
            boolean comesAlongRow = ring.row(before) == ring.row(i);
            boolean leavesAlongRow = ring.row(after) == ring.row(i);
            assertTrue(comesAlongRow != leavesAlongRow, "corner " + i);
        }
    }

    /** Fills rings by the even-odd rule: counts the vertical sides to the left of each cell's middle. */
    static SolidCells scan(List<GridRing> rings, int width, int height) {
        boolean[] solid = new boolean[width * height];
        for (GridRing ring : rings) {
            for (int i = 0; i < ring.size(); i++) {
                int j = (i + 1) % ring.size();
                if (ring.column(i) == ring.column(j)) {
                    int low = Math.min(ring.row(i), ring.row(j));
                    int high = Math.max(ring.row(i), ring.row(j));
                    for (int row = low; row < high; row++) {
                        for (int column = ring.column(i); column < width; column++) {
                            solid[row * width + column] ^= true;
                        }
                    }
                }
            }
        }
        return new SolidCells(width, height, solid);
    }

    static SolidCells randomCells(Random random, int width, int height, double share) {
        boolean[] solid = new boolean[width * height];
        for (int i = 0; i < solid.length; i++) {
            solid[i] = random.nextDouble() < share;
        }
        return new SolidCells(width, height, solid);
    }

    /** Cells from rows of text, the top row first. */
    static SolidCells cells(String... rowsFromTop) {
        int width = rowsFromTop[0].length();
        boolean[] solid = new boolean[width * rowsFromTop.length];
        for (int y = 0; y < rowsFromTop.length; y++) {
            for (int x = 0; x < width; x++) {
                solid[(rowsFromTop.length - 1 - y) * width + x] = rowsFromTop[y].charAt(x) == '#';
            }
        }
        return new SolidCells(width, rowsFromTop.length, solid);
    }
}
