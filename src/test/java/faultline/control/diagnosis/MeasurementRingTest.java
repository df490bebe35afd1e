package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class MeasurementRingTest {

    @Test
    void theLast32MeasurementsAreKept() {
        MeasurementRing ring = new MeasurementRing();
        assertFalse(ring.has(0));
        for (int i = 1; i <= 100; i++) {
            ring.add(i, i + 0.1, i + 0.2, i + 0.3, i + 0.4, i + 0.5, i + 0.6);
            for (int age = 0; age < Math.min(i, 32); age++) {
                int added = i - age;
                assertTrue(ring.has(age));
                assertEquals(added, ring.x(age));
                assertEquals(added + 0.1, ring.y(age));
                assertEquals(added + 0.2, ring.axis(age));
                assertEquals(added + 0.3, ring.axisCos(age));
                assertEquals(added + 0.4, ring.axisSin(age));
                assertEquals(added + 0.5, ring.reading(age));
                assertEquals(added + 0.6, ring.clock(age));
            }
            assertFalse(ring.has(Math.min(i, 32)));
        }
    }

    @Test
    void forgottenMeasurementsCountAsAdded() {
        MeasurementRing ring = new MeasurementRing();
        ring.add(1, 0, 0, 0, 0, 0, 0);
        ring.add(2, 0, 0, 0, 0, 0, 0);
        ring.forget();
        assertFalse(ring.has(0));
        assertEquals(2, ring.count());
        ring.add(3, 0, 0, 0, 0, 0, 0);
        assertTrue(ring.has(0));
        assertEquals(3, ring.x(0));
        assertFalse(ring.has(1));
        assertEquals(3, ring.count());
    }
}
