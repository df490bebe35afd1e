package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ScanTest {

    private final Scan scan = new Scan();

    @Test
    void theTurnEndsThirtyDegreesAfterTheSensorHasPassedThePlace() {
        assertFalse(scan.isActive());
        scan.start(0.5, 0.2, 1, 2);
        assertTrue(scan.isActive());
        assertEquals(1, scan.sign());
        assertEquals(0.2, scan.margin());
        assertFalse(scan.advance(0.5));
        assertFalse(scan.advance(0.52));
        assertTrue(scan.advance(0.01));
        scan.end();
        assertFalse(scan.isActive());
    }

    @Test
    void aTurnClockwiseDoesToo() {
        scan.start(-0.5, 0, 1, 2);
        assertEquals(-1, scan.sign());
        assertFalse(scan.advance(-1.02));
        assertTrue(scan.advance(-0.01));
    }

    @Test
    void withoutASensorThatCanSeeThePlaceItEndsAtOnce() {
        scan.start(Double.NaN, 0, 1, 2);
        assertTrue(scan.advance(0));
    }

    @Test
    void eachScanTurnsFromItsOwnStart() {
        scan.start(0.5, 0, 1, 2);
        scan.advance(1.5);
        scan.start(0.5, 0, 1, 2);
        assertFalse(scan.advance(0.1));
    }

    @Test
    void anotherScanMustLookAtAnotherPlaceAtLeastFiveCentimetresAway() {
        scan.start(0.5, 0, 1, 2);
        assertFalse(scan.mayContinueAt(1, 2));
        assertFalse(scan.mayContinueAt(1.049, 2));
        assertFalse(scan.mayContinueAt(1, 1.951));
        assertFalse(scan.mayContinueAt(1.03, 2.03));
        assertTrue(scan.mayContinueAt(1.04, 2.04));
        assertTrue(scan.mayContinueAt(0.949, 2));
        assertTrue(scan.mayContinueAt(1, 1.949));
    }

    @Test
    void fourScansMayFollowEachOtherUntilTheRobotDrivesOn() {
        for (int i = 1; i <= 3; i++) {
            scan.start(0.5, 0, i, 0);
            assertTrue(scan.mayContinueAt(9, 9), "after scan " + i);
        }
        scan.start(0.5, 0, 4, 0);
        assertFalse(scan.mayContinueAt(9, 9));
        scan.forget();
        assertTrue(scan.mayContinueAt(9, 9));
    }
}
