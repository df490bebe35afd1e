package faultline.floorplan;

import static faultline.floorplan.OutlineTracerTest.cells;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SolidCellsTest {

    @Test
    void specksBelowTheMinimumAreDropped() {
        SolidCells cells = cells("##..#", "#....", "....#");
        assertEquals(cells("##...", "#....", "....."), cells.withoutSpecks(2));
        assertEquals(cells("##...", "#....", "....."), cells.withoutSpecks(3));
        assertEquals(0, cells.withoutSpecks(4).count());
        assertEquals(cells, cells.withoutSpecks(1));
    }

    @Test
    void cellsThatTouchAtACornerAreSeparateSpecks() {
        assertEquals(0, cells("#.", ".#").withoutSpecks(2).count());
    }

    @Test
    void theCornersAreThoseOfTheTracedOutlines() {
        Random random = new Random(5);
        for (int trial = 0; trial < 200; trial++) {
            boolean[] solid = new boolean[12 * 9];
            for (int i = 0; i < solid.length; i++) {
                solid[i] = random.nextBoolean();
            }
            SolidCells cells = new SolidCells(12, 9, solid);
            assertEquals(
                    OutlineTracer.trace(cells).stream().mapToInt(GridRing::size).sum(), cells.cornerCount());
        }
    }

    /** The collected cells of a large group are given up while it is collected. */
    @Test
    void aLargeGroupIsKeptAndTheSmallOnesBehindItAreDropped() {
        boolean[] solid = new boolean[1000 * 1000];
        Arrays.fill(solid, 0, 998 * 1000, true);
        solid[999 * 1000] = true;
        SolidCells kept = new SolidCells(1000, 1000, solid).withoutSpecks(5);
        assertEquals(998 * 1000, kept.count());
        assertFalse(kept.isSolid(0, 999));
    }

    @ParameterizedTest
    @ValueSource(ints = {900, 901, 2000})
    void aSpeckOfHundredsOfCellsIsDroppedAsAWhole(int minCells) {
        boolean[] solid = new boolean[30 * 30];
        Arrays.fill(solid, true);
        int kept = new SolidCells(30, 30, solid).withoutSpecks(minCells).count();
        assertEquals(minCells > 900 ? 0 : 900, kept);
    }

    @Test
    void nothingIsSolidBeyondTheMap() {
        assertFalse(cells("#").isSolid(-1, 0));
        assertFalse(cells("#").isSolid(0, 1));
    }
}
