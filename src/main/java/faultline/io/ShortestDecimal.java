package faultline.io;

import java.math.BigInteger;

/**
 * Converts numbers to the shortest decimal text that reads back to the same bits, with the characters of
 * {@link Double#toString(double)} in a fraction of its time and without allocation. The method is Schubfach (R.
 * Giulietti, The Schubfach way to render doubles, 2020): the interval of the reals that round to a number is scaled by
 * a power of ten, and contains one or two multiples of 1 or 10 of which the nearest is chosen.
 */
public final class ShortestDecimal {

    /** The length of the longest text. */
    public static final int MAX_LENGTH = 26;

    /** Numbers from here on, and below {@link #MIN}, are left to {@link Double#toString(double)}. */
    private static final double MAX = 1e7;

    private static final double MIN = 1e-24;

    /** Smaller numbers are written with an exponent. */
    private static final double MIN_PLAIN = 1e-3;

    /**
     * Of numbers with an exponent and this number of zero bits at the end, {@link Double#toString(double)} of JDK 17
     * writes some with a digit too many, so they are left to it.
     */
    private static final int FEW_BITS = 20;

    private static final int MANTISSA_BITS = 52;
    private static final long MANTISSA = (1L << MANTISSA_BITS) - 1;
    private static final int EXPONENT_BIAS = 1075;
    private static final long LOW_63 = Long.MAX_VALUE;

    /** The powers 10^-k for k from here on are in the table. */
    private static final int MIN_K = -42;

    private static final int MAX_K = -9;
    private static final int G_BITS = 126;
    private static final long[] HIGH = new long[MAX_K - MIN_K + 1];
    private static final long[] LOW = new long[MAX_K - MIN_K + 1];

    private static final long[] POWERS = new long[19];

    /** The place of the decimal point before the first digit, from which on smaller numbers have an exponent. */
    private static final int MIN_POINT = -2;

    private static final long LOWER = 100_000_000;
    private static final int LOWER_DIGITS = 8;

    /** The digits of 00 to 99. */
    private static final char[] PAIRS = new char[200];

    private ShortestDecimal() {}

    static {
        for (int i = 0; i < PAIRS.length; i++) {
            PAIRS[i] = (char) ('0' + (i % 2 == 0 ? i / 20 : i / 2 % 10));
        }
        POWERS[0] = 1;
        for (int i = 1; i < POWERS.length; i++) {
            POWERS[i] = 10 * POWERS[i - 1];
        }
        for (int k = MIN_K; k <= MAX_K; k++) {
            BigInteger g = scaledPower(-k).add(BigInteger.ONE);
            HIGH[k - MIN_K] = g.shiftRight(63).longValueExact();
            LOW[k - MIN_K] = g.longValue() & LOW_63;
        }
    }

    /** Returns the first 126 bits of a power of ten. */
    private static BigInteger scaledPower(int exponent) {
        int shift = G_BITS - 1 - floorLog2OfPower10(exponent);
        BigInteger power = BigInteger.TEN.pow(Math.abs(exponent));
        if (exponent < 0) {
            return BigInteger.ONE.shiftLeft(shift).divide(power);
        }
        return shift < 0 ? power.shiftRight(-shift) : power.shiftLeft(shift);
    }

    /** Returns the greatest integer not above log2(10^e) for exponents of less than 1000. */
    private static int floorLog2OfPower10(int e) {
        return e * 217_706 >> 16;
    }

    /** Returns the greatest integer not above log10(2^e), for exponents of less than 1000. */
    private static int floorLog10OfPower2(int e) {
        return e * 315_653 >> 20;
    }

    /** Returns the greatest integer not above log10(3/4 2^e) for exponents of less than 1000. */
    private static int floorLog10OfThreeQuartersPower2(int e) {
        return e * 315_653 - 131_072 >> 20;
    }

    /**
     * Writes a finite number.
     *
     * @param number finite
     * @param text receives the text from its start; at least {@link #MAX_LENGTH} characters
     * @return the length of the text
     */
    public static int write(double number, char[] text) {
        double magnitude = Math.abs(number);
        long bits = Double.doubleToRawLongBits(magnitude);
        long c = 1L << MANTISSA_BITS | bits & MANTISSA;
        boolean plain = magnitude >= MIN_PLAIN && magnitude < MAX;
        if (!plain && !(magnitude >= MIN && magnitude < MIN_PLAIN && Long.numberOfTrailingZeros(c) < FEW_BITS)) {
            String rare = Double.toString(number);
            rare.getChars(0, rare.length(), text, 0);
            return rare.length();
        }
        int start = number < 0 ? 1 : 0;
        text[0] = '-';
        return convert(c, (int) (bits >>> MANTISSA_BITS) - EXPONENT_BIAS, text, start);
    }

    /** Writes c 2^q, where c has 53 bits, and returns the end of the text. */
    private static int convert(long c, int q, char[] text, int start) {
        boolean regular = c != 1L << MANTISSA_BITS;
        int k = regular ? floorLog10OfPower2(q) : floorLog10OfThreeQuartersPower2(q);
        int h = q + floorLog2OfPower10(-k) + 2;
        long high = HIGH[k - MIN_K];
        long low = LOW[k - MIN_K];
        long odd = c & 1;
        // Four times the number and the ends of its interval, in units of 10^k.
        long value = scaled(high, low, c << 2 << h);
        long from = scaled(high, low, (c << 2) - (regular ? 2 : 1) << h) + odd;
        long to = scaled(high, low, (c << 2) + 2 << h) - odd;
        long below = value >> 2;
        long ten = below / 10 * 10;
        boolean tenBelow = from <= ten << 2;
        boolean tenAbove = ten + 10 << 2 <= to;
        if (tenBelow != tenAbove) {
            return write(tenBelow ? ten : ten + 10, k, text, start);
        }
        boolean isBelow = from <= below << 2;
        boolean isAbove = below + 1 << 2 <= to;
        long middle = value - (2 * below + 1 << 1);
        boolean down = isBelow != isAbove ? isBelow : middle < 0 || middle == 0 && (below & 1) == 0;
        return write(down ? below : below + 1, k, text, start);
    }

    /** Returns the product of a 126-bit and a 64-bit number without its last bits, rounded to odd. */
    private static long scaled(long high, long low, long factor) {
        long upperOfLow = Math.multiplyHigh(low, factor);
        long lowerOfHigh = high * factor;
        long upperOfHigh = Math.multiplyHigh(high, factor);
        long middle = (lowerOfHigh >>> 1) + upperOfLow;
        long whole = upperOfHigh + (middle >>> 63);
        return whole | (middle & LOW_63) + LOW_63 >>> 63;
    }

    /** Writes f 10^k, where f has more than -k - 25 digits, and returns the end of the text. */
    private static int write(long f, int k, char[] text, int start) {
        int length = (Long.SIZE - Long.numberOfLeadingZeros(f)) * 1233 >> 12;
        length += f >= POWERS[length] ? 1 : 0;
        // The first digit is at the power of ten point - 1.
        int point = length + k;
        if (point > 0 || point < MIN_POINT) {
            // The digits before the decimal point move one place to the left.
            int end = split(f, length, text, start + 1);
            int whole = point > 0 ? point : 1;
            System.arraycopy(text, start + 1, text, start, whole);
            text[start + whole] = '.';
            if (end <= start + 1 + whole) {
                text[start + 1 + whole] = '0';
                end = start + 2 + whole;
            }
            return point > 0 ? end : writeExponent(1 - point, text, end);
        }
        for (int i = 0; i < 2 - point; i++) {
            text[start + i] = '0';
        }
        text[start + 1] = '.';
        return split(f, length, text, start + 2 - point);
    }

    private static int writeExponent(int negative, char[] text, int end) {
        text[end] = 'E';
        text[end + 1] = '-';
        if (negative < 10) {
            text[end + 2] = (char) ('0' + negative);
            return end + 3;
        }
        text[end + 2] = PAIRS[2 * negative];
        text[end + 3] = PAIRS[2 * negative + 1];
        return end + 4;
    }

    /** Writes the digits of a number of some length from a place on, and returns the end without trailing zeros. */
    private static int split(long f, int length, char[] text, int start) {
        int upper = (int) (f / LOWER);
        int lower = (int) (f - upper * LOWER);
        int end = start + length;
        if (upper == 0) {
            writeDigits(lower, text, start, end);
        } else {
            writeDigits(lower, text, end - LOWER_DIGITS, end);
            writeDigits(upper, text, start, end - LOWER_DIGITS);
        }
        while (text[end - 1] == '0') {
            end--;
        }
        return end;
    }

    /** Writes the digits of a number, two at a time. */
    private static void writeDigits(int number, char[] text, int start, int end) {
        int rest = number;
        int i = end;
        while (i - start >= 2) {
            int next = rest / 100;
            int pair = 2 * (rest - 100 * next);
            text[--i] = PAIRS[pair + 1];
            text[--i] = PAIRS[pair];
            rest = next;
        }
        if (i > start) {
            text[start] = (char) ('0' + rest);
        }
    }
}
