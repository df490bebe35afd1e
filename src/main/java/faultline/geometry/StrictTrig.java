package faultline.geometry;

/**
 * Sine and cosine with exactly the bits of {@link StrictMath}, without its native call: about three times as fast. The
 * method is that of fdlibm 5.3 (Sun Microsystems 1993, freely granted): the angle is reduced by a multiple of pi / 2
 * that is kept in three parts, and a polynomial approximates the function in [-pi / 4, pi / 4]. Angles beyond 2^19 pi /
 * 2 are left to {@link StrictMath}. A test compares the bits.
 */
public final class StrictTrig {

    private static final double S1 = -1.66666666666666324348e-01;
    private static final double S2 = 8.33333333332248946124e-03;
    private static final double S3 = -1.98412698298579493134e-04;
    private static final double S4 = 2.75573137070700676789e-06;
    private static final double S5 = -2.50507602534068634195e-08;
    private static final double S6 = 1.58969099521155010221e-10;

    private static final double C1 = 4.16666666666666019037e-02;
    private static final double C2 = -1.38888888888741095749e-03;
    private static final double C3 = 2.48015872894767294178e-05;
    private static final double C4 = -2.75573143513906633035e-07;
    private static final double C5 = 2.08757232129817482790e-09;
    private static final double C6 = -1.13596475577881948265e-11;

    private static final double TWO_OVER_PI = 6.36619772367581382433e-01;
    // pi / 2 in parts of 33 bits, each with the rest that follows it.
    private static final double HALF_PI_1 = 1.57079632673412561417e+00;
    private static final double HALF_PI_1_REST = 6.07710050650619224932e-11;
    private static final double HALF_PI_2 = 6.07710050630396597660e-11;
    private static final double HALF_PI_2_REST = 2.02226624879595063154e-21;
    private static final double HALF_PI_3 = 2.02226624871116645580e-21;
    private static final double HALF_PI_3_REST = 8.47842766036889956997e-32;

    // High words of doubles, without the sign.
    private static final int QUARTER_PI = 0x3fe921fb;
    private static final int HALF_PI = 0x3ff921fb;
    private static final int THREE_QUARTER_PI = 0x4002d97c;
    private static final int MAX_REDUCED = 0x413921fb;
    private static final int TINY = 0x3e400000;

    /** The high words of the first multiples of pi / 2, near which the reduction loses digits. */
    private static final int[] MULTIPLES = new int[32];

    static {
        for (int n = 1; n <= MULTIPLES.length; n++) {
            MULTIPLES[n - 1] = highWord(n * (StrictMath.PI / 2));
        }
    }

    private StrictTrig() {}

    /**
     * {@return {@link StrictMath#sin} of an angle in radians}
     *
     * @param x the angle, in radians
     */
    public static double sin(double x) {
        int high = highWord(x);
        if (high <= QUARTER_PI) {
            return kernelSin(x, 0, high, false);
        }
        return high > MAX_REDUCED ? StrictMath.sin(x) : reduced(x, high, 0);
    }

    /**
     * {@return {@link StrictMath#cos} of an angle in radians}
     *
     * @param x the angle, in radians
     */
    public static double cos(double x) {
        int high = highWord(x);
        if (high <= QUARTER_PI) {
            return kernelCos(x, 0, high);
        }
        return high > MAX_REDUCED ? StrictMath.cos(x) : reduced(x, high, 1);
    }

    private static int highWord(double x) {
        return (int) (Double.doubleToRawLongBits(x) >>> 32) & 0x7fffffff;
    }

    /** Returns sin(x + quarters * pi / 2) for |x| from pi / 4 to the greatest reduced angle. */
    private static double reduced(double x, int high, int quarters) {
        double t = Math.abs(x);
        int n;
        double head;
        double tail;
        if (high < THREE_QUARTER_PI) {
            n = 1;
            boolean close = high == HALF_PI;
            double z = close ? t - HALF_PI_1 - HALF_PI_2 : t - HALF_PI_1;
            double rest = close ? HALF_PI_2_REST : HALF_PI_1_REST;
            head = z - rest;
            tail = z - head - rest;
        } else {
            n = (int) (t * TWO_OVER_PI + 0.5);
            double r = t - n * HALF_PI_1;
            double w = n * HALF_PI_1_REST;
            head = r - w;
            if (n >= 32 || high == MULTIPLES[n - 1]) {
                int exponent = high >> 20;
                if (exponent - (highWord(head) >> 20) > 16) {
                    double before = r;
                    w = n * HALF_PI_2;
                    r = before - w;
                    w = n * HALF_PI_2_REST - (before - r - w);
                    head = r - w;
                    if (exponent - (highWord(head) >> 20) > 49) {
                        before = r;
                        w = n * HALF_PI_3;
                        r = before - w;
                        w = n * HALF_PI_3_REST - (before - r - w);
                        head = r - w;
                    }
                }
            }
            tail = r - head - w;
        }
        return x < 0 ? quadrant(-head, -tail, quarters - n) : quadrant(head, tail, quarters + n);
    }

    /** Returns sin(x + y + n * pi / 2). */
    private static double quadrant(double x, double y, int n) {
        int high = highWord(x);
        double value = (n & 1) == 0 ? kernelSin(x, y, high, true) : kernelCos(x, y, high);
        return (n & 2) == 0 ? value : -value;
    }

    private static double kernelSin(double x, double y, int high, boolean hasTail) {
        if (high < TINY) {
            return x;
        }
        double z = x * x;
        double v = z * x;
        double r = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
        return hasTail ? x - (z * (0.5 * y - v * r) - y - v * S1) : x + v * (S1 + z * r);
    }

    private static double kernelCos(double x, double y, int high) {
        if (high < TINY) {
            return 1;
        }
        double z = x * x;
        double r = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
        if (high < 0x3fd33333) {
            return 1 - (0.5 * z - (z * r - x * y));
        }
        double quarter = high > 0x3fe90000 ? 0.28125 : Double.longBitsToDouble((long) (high - 0x00200000) << 32);
        return 1 - quarter - (0.5 * z - quarter - (z * r - x * y));
    }
}
