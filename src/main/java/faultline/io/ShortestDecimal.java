package faultline.io;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.math.BigInteger;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Converts numbers to the shortest decimal text that reads back to the same bits, with the characters that
 * {@link Double#toString(double)} specifies since JDK 19, on any JDK, in a fraction of its time and without allocation.
 * The method is Schubfach (R. Giulietti, The Schubfach way to render doubles, 2020): the interval of the reals that
 * round to a number is scaled by a power of ten, and contains at most one multiple of 10, which is chosen, or else the
 * nearest integer. Digits are converted and written eight at a time, nearly without branches, because branches on
 * digits cannot be predicted.
 */
public final class ShortestDecimal {

    /** The number of bytes that a text may need; some bytes after its end are overwritten. */
    public static final int ROOM = 32;

    /**
     * Numbers of at least this value, and below {@link #MIN}, are left to {@link RareDecimal}, and so are powers of
     * two, whose intervals are not symmetric.
     */
    private static final double MAX = 1e7;

    private static final double MIN = 1e-24;

    private static final int MANTISSA_BITS = 52;
    private static final long MANTISSA = (1L << MANTISSA_BITS) - 1;
    private static final int EXPONENT_BIAS = 1075;
    private static final long LOW_63 = Long.MAX_VALUE;

    /** The least k for which the power 10^-k is in the table. */
    private static final int MIN_K = -42;

    private static final int MAX_K = -9;
    private static final int G_BITS = 126;
    private static final long[] HIGH = new long[MAX_K - MIN_K + 1];
    private static final long[] LOW = new long[MAX_K - MIN_K + 1];

    /** All numbers are converted to this number of digits, with zeros at the end. */
    private static final int DIGITS = 17;

    private static final long MIN_WITH_ALL_DIGITS = 10_000_000_000_000_000L;
    private static final int EIGHT_DIGITS = 100_000_000;

    /** The lowest position of the decimal point, before the first digit; smaller numbers have an exponent. */
    private static final int MIN_POINT = -2;

    private static final int MAX_POINT = 7;

    /** For each place of the decimal point, the mask of the first digits that are before it. */
    private static final long[] WHOLE = new long[MAX_POINT - MIN_POINT + 1];

    /** For each place of the decimal point, the point, with the zeros that are before the first digit. */
    private static final long[] POINT = new long[MAX_POINT - MIN_POINT + 1];

    /** Eight zeros; also turns eight digits into characters. */
    private static final long ZEROS = 0x3030_3030_3030_3030L;

    /** The texts of the powers of two so far, and of zero; a double has some 4000 of them. */
    private static final Map<Double, byte[]> POWERS = new ConcurrentHashMap<>();

    /** Eight characters of a text, the first in the lowest byte. */
    private static final VarHandle EIGHT = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    private ShortestDecimal() {}

    static {
        for (int k = MIN_K; k <= MAX_K; k++) {
            BigInteger g = scaledPower(-k).add(BigInteger.ONE);
            HIGH[k - MIN_K] = g.shiftRight(63).longValueExact();
            LOW[k - MIN_K] = g.longValue() & LOW_63;
        }
        for (int point = MIN_POINT; point <= MAX_POINT; point++) {
            boolean plain = point > 0;
            WHOLE[point - MIN_POINT] = plain ? firstBytes(point) : 0;
            POINT[point - MIN_POINT] = plain ? (long) '.' << Byte.SIZE * point : 0x3030_2E30 & firstBytes(2 - point);
        }
    }

    private static long firstBytes(int count) {
        return (1L << Byte.SIZE * count) - 1;
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

    /**
     * {@return the text of a number}
     *
     * @param number the number, finite
     */
    public static String text(double number) {
        byte[] text = new byte[ROOM];
        return new String(text, 0, write(number, text, 0), StandardCharsets.ISO_8859_1);
    }

    /**
     * Writes a finite number.
     *
     * @param number the number, finite
     * @param text receives the text
     * @param start the index at which the text begins; the array must have {@link #ROOM} bytes from there on
     * @return the end of the text
     */
    public static int write(double number, byte[] text, int start) {
        double magnitude = Math.abs(number);
        long bits = Double.doubleToRawLongBits(magnitude);
        long mantissa = bits & MANTISSA;
        if (mantissa == 0 || magnitude < MIN || magnitude >= MAX) {
            return writeRare(number, mantissa == 0, text, start);
        }
        text[start] = '-';
        int q = (int) (bits >>> MANTISSA_BITS) - EXPONENT_BIAS;
        return convert(1L << MANTISSA_BITS | mantissa, q, text, number < 0 ? start + 1 : start);
    }

    /** Writes any number. Powers of two are cached, because rounding errors are often powers of two. */
    private static int writeRare(double number, boolean power, byte[] text, int start) {
        byte[] rare = power ? POWERS.computeIfAbsent(number, ShortestDecimal::rareText) : rareText(number);
        System.arraycopy(rare, 0, text, start, rare.length);
        return start + rare.length;
    }

    private static byte[] rareText(double number) {
        return RareDecimal.text(number).getBytes(StandardCharsets.ISO_8859_1);
    }

    /** Writes c 2^q, where c has 53 bits and is not a power of two, and returns the end of the text. */
    private static int convert(long c, int q, byte[] text, int start) {
        int k = floorLog10OfPower2(q);
        int h = q + floorLog2OfPower10(-k) + 2;
        long high = HIGH[k - MIN_K];
        long low = LOW[k - MIN_K];
        long odd = c & 1;
        // Four times the number and the ends of its interval, in units of 10^k.
        long value = scaled(high, low, c << 2 << h);
        long from = scaled(high, low, (c << 2) - 2 << h) + odd;
        long to = scaled(high, low, (c << 2) + 2 << h) - odd;
        long below = value >> 2;
        // If two integers are equally near, the even one is chosen.
        long nearest = below + ((value & 3) + (below & 1) + 1 >> 2);
        long tenBelow = below / 10 * 10;
        // -1 or 0, because a branch would be mispredicted often.
        long outsideBelow = (tenBelow << 2) - from >> 63;
        long outsideAbove = to - (tenBelow + 10 << 2) >> 63;
        long ten = tenBelow + (10 & ~outsideAbove);
        return write(ten + (nearest - ten & ~(outsideBelow ^ outsideAbove)), k, text, start);
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

    /** Writes f 10^k, where f has 16 or 17 digits, and returns the end of the text. */
    private static int write(long f, int k, byte[] text, int start) {
        // -1 if there are 16.
        long less = f - MIN_WITH_ALL_DIGITS >> 63;
        long digits = f + (9 * f & less);
        // The first digit is at the power of ten point - 1.
        int point = DIGITS + (int) less + k;
        long upper = digits / EIGHT_DIGITS;
        // By 10^8: exact for at most nine digits.
        long first = upper * 1_441_151_881 >>> 57;
        long middle = eightDigits(upper - first * EIGHT_DIGITS);
        long last = eightDigits(digits - upper * EIGHT_DIGITS);
        int zeros = last == 0 ? 8 + trailingZeros(middle) : trailingZeros(last);
        int place = point < MIN_POINT ? 1 : point;
        int before = place > 0 ? 1 : 2 - place;
        EIGHT.set(text, start + before + 1, middle | ZEROS);
        EIGHT.set(text, start + before + 9, last | ZEROS);
        // The first eight digits again, because those before the point move one to the left.
        long head = first | middle << Byte.SIZE | ZEROS;
        long whole = head & WHOLE[place - MIN_POINT];
        EIGHT.set(text, start, whole | POINT[place - MIN_POINT] | head - whole << Byte.SIZE * before);
        int end = start + before + Math.max(DIGITS - zeros, place + 1);
        return point < MIN_POINT ? writeExponent(1 - point, text, end) : end;
    }

    /** Returns the number of zeros at the end of eight digits. */
    private static int trailingZeros(long digits) {
        return Long.numberOfLeadingZeros(digits) >>> 3;
    }

    /**
     * Returns the eight digits of a number, one in each byte, the first in the lowest. Each step divides all parts of
     * the number by products with reciprocals that are exact for such small numbers, and puts the remainders beside the
     * quotients: 2^16 (n - 100 q) + q = 2^16 n - (2^16 100 - 1) q.
     */
    private static long eightDigits(long number) {
        long upper = number * 109_951_163 >>> 40;
        long fours = (number << 32) - ((10_000L << 32) - 1) * upper;
        long hundreds = fours * 10_486 >>> 20 & 0x7F_0000_007FL;
        long twos = (fours << 16) - ((100 << 16) - 1) * hundreds;
        long tens = twos * 103 >>> 10 & 0xF_000F_000F_000FL;
        return (twos << 8) - ((10 << 8) - 1) * tens;
    }

    private static int writeExponent(int negative, byte[] text, int end) {
        text[end] = 'E';
        text[end + 1] = '-';
        if (negative < 10) {
            text[end + 2] = (byte) ('0' + negative);
            return end + 3;
        }
        text[end + 2] = (byte) ('0' + negative / 10);
        text[end + 3] = (byte) ('0' + negative % 10);
        return end + 4;
    }
}
