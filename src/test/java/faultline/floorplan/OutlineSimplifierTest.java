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
        assertEquals(
                List.of("5,3", "25,3", "25,11", "14,15"),
                IntStream.range(0, simple.size())
                        .mapToObj(i -> simple.column(i) + "," + simple.row(i))
                        .toList());
        assertEquals(7, OutlineSimplifier.simplify(ring, 0.9).size());
    }

    @Test
    void aBoundOfNothingKeepsEveryCorner() {
        GridRing ring = OutlineTracer.trace(cells("#..", "##.", "###")).get(0);
        assertEquals(ring.size(), OutlineSimplifier.simplify(ring, 0).size());
    }

    /** A narrow outline would otherwise become a line, and a small one a point. */
    @Test
    void anOutlineOfWhichLessThanATriangleWouldBeLeftStays() {
        GridRing narrow = OutlineTracer.trace(cells("##########")).get(0);
        assertEquals(narrow, OutlineSimplifier.simplify(narrow, 2));
        GridRing small = OutlineTracer.trace(cells("##", "#.")).get(0);
        assertEquals(small, OutlineSimplifier.simplify(small, 5));
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
