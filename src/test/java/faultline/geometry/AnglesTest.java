package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Normalised angles have the bits of the JDK's IEEE remainder. */
class AnglesTest {

    private static final int CASES = 300_000;

    private final SplittableRandom random = new SplittableRandom(4711);

    private static void assertSame(double angle) {
        double expected = angle;
        if (!(angle > -Math.PI && angle <= Math.PI)) {
            double rest = StrictMath.IEEEremainder(angle, 2 * Math.PI);
            expected = rest <= -Math.PI ? rest + 2 * Math.PI : rest;
        }
        assertEquals(
                Double.doubleToRawLongBits(expected),
                Double.doubleToRawLongBits(Angles.normalize(angle)),
                () -> "angle " + angle);
    }

    @Test
    void anglesOfAnySizeAgree() {
        for (int i = 0; i < CASES; i++) {
            assertSame(random.nextDouble(-10, 10));
            assertSame(random.nextDouble(-1e4, 1e4));
            assertSame((random.nextDouble() - 0.5) * Math.pow(10, random.nextDouble(0, 20)));
        }
    }

    @Test
    void anglesNearMultiplesOfHalfATurnAgree() {
        for (int i = 0; i < CASES; i++) {
            double angle = random.nextInt(-3_000_000, 3_000_000) * Math.PI;
            for (int step = random.nextInt(6); step > 0; step--) {
                angle = random.nextBoolean() ? Math.nextUp(angle) : Math.nextDown(angle);
            }
            assertSame(angle);
            assertSame(random.nextInt(-40, 40) * Math.PI + random.nextDouble(-1e-12, 1e-12));
            assertSame(random.nextInt(-40, 40) * 2 * Math.PI);
        }
    }

    @Test
    void theDifferenceIsTheSmallestTurnToTheSecondDirection() {
        assertEquals(0.5, Angles.difference(1, 1.5));
        assertEquals(-0.5, Angles.difference(1.5, 1));
        assertEquals(0.2, Angles.difference(Math.PI - 0.1, -Math.PI + 0.1), 1e-15);
        assertEquals(Math.PI, Angles.difference(0, -Math.PI));
    }
}
