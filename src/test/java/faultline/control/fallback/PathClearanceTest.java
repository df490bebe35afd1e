package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class PathClearanceTest {

    @Test
    void aroundKeepsTheSameDistanceFromAllSurfaces() {
        assertEquals(new PathClearance(0.3, 0.3, 0), PathClearance.around(0.3));
        assertTrue(PathClearance.around(0.3).isSameAround());
    }

    @Test
    void surfacesOnTheRightMayBeNearer() {
        assertFalse(new PathClearance(0.4, 0.3, 0.1).isSameAround());
        assertTrue(new PathClearance(0.4, 0.4, 0.1).isSameAround());
    }
}
