package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Sine and cosine have the bits of StrictMath for every kind of angle. */
class StrictTrigTest {

    private static final int CASES = 300_000;

    private final SplittableRandom random = new SplittableRandom(1302);

    @Test
    void anglesOfAnySizeAgree() {
        for (int i = 0; i < CASES; i++) {
            assertSame(random.nextDouble(-4, 4));
            assertSame(random.nextDouble(-1e6, 1e6));
            assertSame(Double.longBitsToDouble(random.nextLong()));
        }
    }

    @Test
    void anglesNearMultiplesOfARightAngleAgree() {
        for (int i = 0; i < CASES; i++) {
            double angle = random.nextInt(-600_000, 600_000) * (Math.PI / 2);
            for (int step = random.nextInt(6); step > 0; step--) {
                angle = random.nextBoolean() ? Math.nextUp(angle) : Math.nextDown(angle);
            }
            assertSame(angle);
            double small = random.nextInt(-40, 40) * (Math.PI / 4);
            assertSame(small * (1 + random.nextDouble(-1, 1) * Math.pow(10, -random.nextInt(17))));
        }
    }

    @Test
    void specialValuesAgree() {
        for (double angle : new double[] {
            0.0,
            -0.0,
            Double.MIN_VALUE,
            Double.MAX_VALUE,
            Double.NaN,
            Double.POSITIVE_INFINITY,
            Math.PI / 4,
            Math.PI / 2
        }) {
            assertSame(angle);
            assertSame(-angle);
        }
    }

    private static void assertSame(double angle) {
        assertEquals(
                Double.doubleToLongBits(StrictMath.sin(angle)),
                Double.doubleToLongBits(StrictTrig.sin(angle)),
                () -> "sin " + angle);
        assertEquals(
                Double.doubleToLongBits(StrictMath.cos(angle)),
                Double.doubleToLongBits(StrictTrig.cos(angle)),
                () -> "cos " + angle);
    }
}
