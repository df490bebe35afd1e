package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class IntersectionPainterTest {

    /** At 19 pixels per metre, a robot of 0.25 m is half as long as the diameter of a ring of full size. */
    @ParameterizedTest
    @CsvSource({"100, 5", "30, 5", "18, 3", "1, 1.5"})
    void ringsAreSmallerInViewsOfLargeWorlds(double scale, double radius) {
        assertEquals(radius, IntersectionPainter.radius(scale), 1e-12);
    }
}
