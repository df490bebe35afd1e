package faultline.floorplan;

import static faultline.floorplan.OutlineTracerTest.cells;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import java.util.Random;
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

    @Test
    void aBoundOfNothingKeepsEveryCorner() {
        GridRing ring = OutlineTracer.trace(cells("#..", "##.", "###")).get(0);
        assertEquals(ring.size(), OutlineSimplifier.simplify(ring, 0).size());
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
