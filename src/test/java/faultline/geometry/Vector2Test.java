package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Tests vectors, and the positions of poses, with numbers that can be checked by hand. */
class Vector2Test {

    @Test
    void vectorsAreAddedAndSubtractedByComponents() {
        assertEquals(new Vector2(4, -3), new Vector2(1, 2).plus(new Vector2(3, -5)));
        assertEquals(new Vector2(-2, 7), new Vector2(1, 2).minus(new Vector2(3, -5)));
    }

    @Test
    void aQuarterTurnIsToTheLeft() {
        assertEquals(new Vector2(-2, 1), new Vector2(1, 2).perpendicular());
        assertEquals(new Vector2(1, 2).perpendicular(), new Vector2(1, 2).rotated(0, 1));
    }

    @Test
    void aVectorIsFiniteOnlyIfBothComponentsAre() {
        assertTrue(new Vector2(1, 2).isFinite());
        assertFalse(new Vector2(Double.NaN, 2).isFinite());
        assertFalse(new Vector2(1, Double.NEGATIVE_INFINITY).isFinite());
    }

    @Test
    void aPoseKeepsItsHeadingAtAnotherPosition() {
        Pose moved = new Pose(1, 2, 0.5).withPosition(new Vector2(3, 4));
        assertEquals(new Pose(3, 4, 0.5), moved);
        assertEquals(new Vector2(3, 4), moved.position());
    }
}
