package faultline.floorplan;

import static faultline.floorplan.OutlineTracerTest.cells;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class OutlineSimplifierTest {

    @Test
    void aStaircaseBecomesASlantedLine() {
        GridRing ring = OutlineTracer.trace(cells("#.....", "##....", "###...", "####..", "#####.", "######"))
                .get(0);
        GridRing simple = OutlineSimplifier.simplify(ring, 1);
        assertTrue(ring.size() > 10 && simple.size() <= 5, ring.size() + " to " + simple.size());
    }

    @Test
    void everyCornerThatIsLeftOutIsWithinTheBoundOfTheOutline() {
        Random random = new Random(2);
        for (int trial = 0; trial < 300; trial++) {
            double tolerance = random.nextDouble() * 3;
            for (GridRing ring : OutlineTracer.trace(OutlineTracerTest.randomCells(random, 12, 12, 0.6))) {
                GridRing simple = OutlineSimplifier.simplify(ring, tolerance);
                for (int i = 0; i < ring.size(); i++) {
                    assertTrue(distance(simple, ring.column(i), ring.row(i)) <= tolerance + 1e-9);
                }
            }
        }
    }

    /**
     * The corner farthest from the first is the fourth, the corners farthest from the chord between these two are the
     * third and the sixth, at 7.4 and 7.8 cells, and the others are 1, 1.8 and 1.2 cells from the sides that are left.
     */
    @Test
    void theCornersThatAreFarthestFromTheChordsAreKept() {
        GridRing ring = new GridRing(new int[] {5, 15, 25, 25, 17, 14, 8}, new int[] {3, 2, 3, 11, 12, 15, 9});
        GridRing simple = OutlineSimplifier.simplify(ring, 2);
        assertEquals(List.of("5,3", "25,3", "25,11", "14,15"), corners(simple));
        assertEquals(7, OutlineSimplifier.simplify(ring, 0.9).size());
    }

    @Test
    void aBoundOfNothingKeepsEveryCorner() {
        GridRing ring = OutlineTracer.trace(cells("#..", "##.", "###")).get(0);
        assertEquals(ring.size(), OutlineSimplifier.simplify(ring, 0).size());
    }

    @Test
    void aRectangleStays() {
        GridRing narrow = OutlineTracer.trace(cells("##########")).get(0);
        assertEquals(narrow, OutlineSimplifier.simplify(narrow, 2));
        GridRing cell = OutlineTracer.trace(cells("#")).get(0);
        assertEquals(cell, OutlineSimplifier.simplify(cell, 100));
    }

    /**
     * A small outline would otherwise become a point, and a narrow one a line. The corner farthest from the first,
     * which is (0, 0), is (8, 1) in the second outline, and of the others (8, 0), (4, 2) and (0, 1), which are 8, 12
     * and 8 from the line through both, times its length, the second one is the farthest.
     */
    @Test
    void anOutlineOfWhichLessThanATriangleWouldBeLeftBecomesATriangle() {
        GridRing small = OutlineTracer.trace(cells("##", "#.")).get(0);
        GridRing triangle = OutlineSimplifier.simplify(small, 5);
        assertEquals(3, triangle.size());
        assertTrue(Math.abs(doubleArea(triangle)) >= 1);
        GridRing narrow = new GridRing(new int[] {0, 8, 8, 4, 0}, new int[] {0, 0, 1, 2, 1});
        assertEquals(List.of("0,0", "8,1", "4,2"), corners(OutlineSimplifier.simplify(narrow, 3)));
        assertEquals(List.of("0,0", "8,1", "4,2"), corners(OutlineSimplifier.simplify(narrow, 100)));
    }

    /** (-6, 0) is 6 from the chord between (0, 0) and (9, 0), but on its line; the others are 1 and 2 from it. */
    @Test
    void cornersOnALineAreCompletedToATriangle() {
        GridRing flat = new GridRing(new int[] {0, 4, 9, 2, -6}, new int[] {0, 1, 0, -2, 0});
        assertEquals(List.of("0,0", "9,0", "2,-2", "-6,0"), corners(OutlineSimplifier.simplify(flat, 3)));
    }

    @Test
    void noMoreCornersAreLeftIfTheBoundIsLarger() {
        Random random = new Random(3);
        for (int trial = 0; trial < 100; trial++) {
            for (GridRing ring : OutlineTracer.trace(OutlineTracerTest.randomCells(random, 12, 12, 0.4))) {
                int before = ring.size();
                for (double tolerance : new double[] {0, 0.5, 0.8, 1, 1.5, 2, 5, 100}) {
                    GridRing simple = OutlineSimplifier.simplify(ring, tolerance);
                    assertTrue(simple.size() <= before, before + " to " + simple.size() + " at " + tolerance);
                    assertTrue(simple.size() >= 3);
                    before = simple.size();
                }
                assertTrue(before <= 4, () -> "as many corners as " + ring.size());
            }
        }
    }

    /** Each division of a comb takes one tooth off, so that all divisions together took quadratic time. */
    @Test
    void aCombIsSimplifiedInAlmostLinearTime() {
        int teeth = 50_000;
        int[] columns = new int[4 * teeth];
        int[] rows = new int[4 * teeth];
        for (int i = 0; i < 4 * teeth; i++) {
            columns[i] = (i + 1) / 2;
            rows[i] = i % 4 == 0 || i % 4 == 3 ? 0 : 1;
        }
        GridRing comb = new GridRing(columns, rows);
        CpuTime time = CpuTime.start();
        GridRing simple = OutlineSimplifier.simplify(comb, 0.4);
        time.assertBelow(5);
        for (int i = 0; i < comb.size(); i += 9973) {
            assertTrue(distance(simple, comb.column(i), comb.row(i)) <= 0.4);
        }
    }

    private static List<String> corners(GridRing ring) {
        return IntStream.range(0, ring.size())
                .mapToObj(i -> ring.column(i) + "," + ring.row(i))
                .toList();
    }

    private static int doubleArea(GridRing ring) {
        return IntStream.range(0, ring.size())
                .map(i -> {
                    int next = (i + 1) % ring.size();
                    return ring.column(i) * ring.row(next) - ring.column(next) * ring.row(i);
                })
                .sum();
    }

    private static double distance(GridRing ring, double x, double y) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ring.size(); i++) {
            int j = (i + 1) % ring.size();
            double dx = ring.column(j) - ring.column(i);
            double dy = ring.row(j) - ring.row(i);
            double px = x - ring.column(i);
            double py = y - ring.row(i);
            double t = Math.max(0, Math.min(1, (px * dx + py * dy) / Math.max(1e-12, dx * dx + dy * dy)));
            nearest = Math.min(nearest, Math.hypot(px - t * dx, py - t * dy));
        }
        return nearest;
    }
}
