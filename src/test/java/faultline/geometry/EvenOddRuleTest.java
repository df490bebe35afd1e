package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EvenOddRuleTest {

    /** A room in the form of an L. */
    private static final List<Vector2> RING = List.of(
            new Vector2(0, 0),
            new Vector2(4, 0),
            new Vector2(4, 1),
            new Vector2(1, 1),
            new Vector2(1, 3),
            new Vector2(0, 3));

    @ParameterizedTest
    @CsvSource({
        "0.5, 0.5, true",
        "3, 0.5, true",
        "0.5, 2, true",
        "2, 2, false",
        "-1, 2, false",
        "5, 0.5, false",
        "0.5, 3.5, false",
        "0.5, -0.5, false"
    })
    void aPointIsInsideOrOutsideInEitherOrderOfTheCorners(double x, double y, boolean inside) {
        Vector2 point = new Vector2(x, y);
        assertEquals(inside, EvenOddRule.isInside(RING, point));
        List<Vector2> reversed = new ArrayList<>(RING);
        Collections.reverse(reversed);
        assertEquals(inside, EvenOddRule.isInside(reversed, point));
    }

    /** The line through (1, 2) and (4, 8): the ray crosses it left of x = y / 2. */
    @ParameterizedTest
    @CsvSource({"1.4, 3, true", "1.6, 3, false", "2.9, 6, true", "3.1, 6, false", "0, 1.9, false", "0, 8.1, false"})
    void theRayCrossesASlantedSideThatIsOnTheRight(double x, double y, boolean crosses) {
        assertEquals(crosses, EvenOddRule.crosses(x, y, 1, 2, 4, 8));
        assertEquals(crosses, EvenOddRule.crosses(x, y, 4, 8, 1, 2));
    }

    @Test
    void aRingThatGoesRoundTwiceHasAHole() {
        List<Vector2> twice = List.of(
                new Vector2(0, 0),
                new Vector2(4, 0),
                new Vector2(4, 4),
                new Vector2(0, 4),
                new Vector2(0, 0),
                new Vector2(1, 1),
                new Vector2(3, 1),
                new Vector2(3, 3),
                new Vector2(1, 3),
                new Vector2(1, 1));
        assertFalse(EvenOddRule.isInside(twice, new Vector2(2, 2)));
        assertTrue(EvenOddRule.isInside(twice, new Vector2(0.5, 2)));
    }

    @Test
    void theLowerEndOfASideBelongsToItAndTheUpperOneDoesNot() {
        assertTrue(EvenOddRule.crosses(0, 1, 2, 1, 2, 5));
        assertFalse(EvenOddRule.crosses(0, 5, 2, 1, 2, 5));
        assertFalse(EvenOddRule.crosses(0, 1, 2, 1, 5, 1));
        assertFalse(EvenOddRule.crosses(2, 3, 2, 1, 2, 5));
    }
}
