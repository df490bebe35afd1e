package faultline.floorplan;

import static faultline.floorplan.OutlineTracerTest.cells;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.junit.jupiter.api.Test;

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
    void nothingIsSolidBeyondTheMap() {
        assertFalse(cells("#").isSolid(-1, 0));
        assertFalse(cells("#").isSolid(0, 1));
    }
}
