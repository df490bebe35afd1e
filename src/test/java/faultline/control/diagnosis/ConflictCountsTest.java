package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ConflictCountsTest {

    private static final int ALL = 0b1111;

    private final ConflictCounts counts = new ConflictCounts(4);

    @Test
    void aContradictionCountsAgainstBoth() {
        counts.add(1, 3, 2);
        assertEquals(2, counts.against(1, ALL));
        assertEquals(2, counts.against(3, ALL));
        assertEquals(0, counts.against(0, ALL));
        assertEquals(2, counts.pair(1, 3));
        assertEquals(2, counts.pair(3, 1));
        assertEquals(0, counts.pair(1, 1));
        assertTrue(counts.isActive(1) && counts.isActive(3));
        assertFalse(counts.isActive(0) || counts.isActive(2));
    }

    @Test
    void onlyThePairsWithSensorsThatAreAskedCountAndAlwaysItsOwn() {
        counts.add(1, 1, 0.5);
        counts.add(1, 0, 1);
        counts.add(1, 2, 2);
        counts.add(1, 3, 4);
        assertEquals(7.5, counts.against(1, ALL));
        assertEquals(0.5, counts.against(1, 0));
        assertEquals(4.5, counts.against(1, 0b1000));
        assertEquals(3.5, counts.against(1, 0b0111));
    }

    @Test
    void oneSensorAloneCannotCountForMoreThanSix() {
        for (int i = 0; i < 30; i++) {
            counts.add(0, 1, 1);
            counts.add(2, 2, 1);
        }
        assertEquals(6, counts.against(0, ALL));
        assertEquals(20, counts.against(2, ALL));
    }

    @Test
    void twoDisagreeAboveFive() {
        counts.add(0, 1, 5);
        assertFalse(counts.isDisagreement(0, 1));
        counts.add(0, 1, 0.01);
        assertTrue(counts.isDisagreement(0, 1));
        assertTrue(counts.isDisagreement(1, 0));
        counts.add(2, 2, 20);
        assertFalse(counts.isDisagreement(2, 2));
    }

    @Test
    void countsOfOneSensorFadeUntilTheyAreForgotten() {
        counts.add(0, 1, 2);
        counts.add(0, 0, 1);
        counts.fade(0, 0.5);
        assertEquals(1.5, counts.against(0, ALL));
        assertEquals(2, counts.against(1, ALL), "the other one fades by itself");
        for (int i = 0; i < 6; i++) {
            counts.fade(0, 0.5);
        }
        assertTrue(counts.isActive(0), "0.016 is left of the pair");
        counts.fade(0, 0.5);
        assertFalse(counts.isActive(0));
        assertEquals(0, counts.against(0, ALL));
        assertEquals(2, counts.pair(1, 0));
        counts.fade(3, 0.5);
        assertEquals(0, counts.against(3, ALL));
        counts.add(0, 1, 1);
        counts.fade(0, 0.5);
        assertEquals(0.5, counts.against(0, ALL), "an active count fades again");
    }

    @Test
    void itsOwnCountCanBeClearedAlone() {
        counts.add(2, 2, 3);
        counts.add(2, 0, 1);
        counts.clearSelf(2);
        assertEquals(1, counts.against(2, ALL));
    }
}
