package faultline.floorplan;

import static faultline.floorplan.OutlineTracerTest.cells;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
