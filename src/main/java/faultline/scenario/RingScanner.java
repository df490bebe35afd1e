package faultline.scenario;

import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.scenario.xml.NumberRange;
import faultline.world.ObstacleShape.PlanShape;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Reads points in the form of files: x,y pairs with blanks between the pairs, in one ring or in several with {@code |}
 * between them. They are read up to a number of points, because a hostile file may hold millions, and straight into
 * arrays of coordinates, because the plan of a building has tens of thousands.
 */
final class RingScanner {

    private static final double LEAST = NumberRange.COORDINATE.min().doubleValue();
    private static final double MOST = NumberRange.COORDINATE.max().doubleValue();
    private static final char SEPARATOR = '|';

    private final String text;
    private final boolean separated;
    private final byte[] bytes;
    private int ringBegin;
    /** The index of the next character. */
    private int position;

    private double[] xs = new double[16];
    private double[] ys = new double[16];
    /** The index of the first point of each ring, and the number of all points. */
    private int[] starts = new int[16];

    private int ringCount;
    private int pointCount;

    /** Creates a scanner of a text, which may have several rings if they are separated. */
    RingScanner(String text, boolean separated) {
        this.text = text;
        this.separated = separated;
        bytes = toBytes(text);
    }

    /** Returns a byte for each character. One that is not of Latin-1 becomes one that is in no valid pair either. */
    private static byte[] toBytes(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        if (bytes.length < text.length()) {
            // Two surrogates have become one byte.
            bytes = new byte[text.length()];
            for (int i = 0; i < bytes.length; i++) {
                bytes[i] = (byte) Math.min(text.charAt(i), Byte.MAX_VALUE);
            }
        }
        return bytes;
    }

    /**
     * Reads the next ring up to its end, an invalid pair or a number of points, whatever comes first, and returns the
     * number of its points.
     */
    int scanRing(int most) {
        int first = pointCount;
        skipBlanks();
        while (!isRingRead() && pointCount - first < most && scanPair()) {
            skipBlanks();
        }
        ringCount++;
        if (ringCount == starts.length) {
            starts = Arrays.copyOf(starts, 2 * ringCount);
        }
        starts[ringCount] = pointCount;
        return pointCount - first;
    }

    /** Goes to the next ring, and returns false if there is none. */
    boolean advance() {
        ringBegin = ringEnd() + 1;
        position = ringBegin;
        return position <= bytes.length;
    }

    /** Returns whether the present ring has been read to its end. */
    boolean isRingRead() {
        return isRingEnd(position);
    }

    /** Returns the pair at which the present ring has been left. */
    String pair() {
        int end = position;
        while (!isPairEnd(end)) {
            end++;
        }
        return text.substring(position, end);
    }

    /** Returns the text of the present ring. */
    String ring() {
        return text.substring(ringBegin, ringEnd());
    }

    private int ringEnd() {
        int end = separated ? text.indexOf(SEPARATOR, position) : -1;
        return end < 0 ? bytes.length : end;
    }

    private void skipBlanks() {
        while (position < bytes.length && isBlank(bytes[position])) {
            position++;
        }
    }

    private static boolean isBlank(byte c) {
        return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f';
    }

    private boolean isRingEnd(int index) {
        return index == bytes.length || separated && bytes[index] == SEPARATOR;
    }

    private boolean isPairEnd(int index) {
        return isRingEnd(index) || isBlank(bytes[index]);
    }

    /** Reads a pair, or returns false and stays before it if it is invalid. */
    private boolean scanPair() {
        double x = Double.NaN;
        boolean first = true;
        int begin = position;
        int point = -1;
        long digits = 0;
        int i = position;
        for (; i < bytes.length; i++) {
            byte c = bytes[i];
            if (c >= '0' && c <= '9') {
                digits = 10 * digits + c - '0';
            } else if (c == '.' && point < 0) {
                point = i;
            } else if (c == ',' && first) {
                x = number(digits, begin, point, i);
                first = false;
                begin = i + 1;
                point = -1;
                digits = 0;
            } else if (c != '-' || i > begin) {
                break;
            }
        }
        double y = number(digits, begin, point, i);
        if (!isPairEnd(i) || !isInside(x) || !isInside(y)) {
            return scanUnusualPair();
        }
        add(x, y, i);
        return true;
    }

    /** Returns the number in a part of the text with some digits, NaN if it is not short. */
    private double number(long digits, int from, int point, int to) {
        boolean negative = from < to && bytes[from] == '-';
        int begin = negative ? from + 1 : from;
        if (begin == to || begin == point || to - begin > DecimalText.MAX_SHORT_LENGTH) {
            return Double.NaN;
        }
        double size = DecimalText.shift(digits, point < 0 ? 0 : to - point - 1);
        return negative ? -size : size;
    }

    private static boolean isInside(double coordinate) {
        return coordinate > LEAST && coordinate < MOST;
    }

    /** Reads a pair with numbers that are longer, have an exponent or are bounds of their range. */
    private boolean scanUnusualPair() {
        String pair = pair();
        int comma = pair.indexOf(',');
        double x = coordinate(pair.substring(0, Math.max(comma, 0)));
        double y = coordinate(pair.substring(comma + 1));
        if (Double.isNaN(x) || Double.isNaN(y)) {
            return false;
        }
        add(x, y, position + pair.length());
        return true;
    }

    /** Returns the coordinate with a text, NaN if it is invalid. */
    private static double coordinate(String number) {
        Optional<BigDecimal> exact = DecimalText.parse(number).filter(NumberRange.COORDINATE::contains);
        return exact.isPresent() ? DecimalText.toDouble(exact.get(), number) : Double.NaN;
    }

    private void add(double x, double y, int end) {
        if (pointCount == xs.length) {
            xs = Arrays.copyOf(xs, 2 * pointCount);
            ys = Arrays.copyOf(ys, 2 * pointCount);
        }
        xs[pointCount] = x;
        ys[pointCount] = y;
        pointCount++;
        position = end;
    }

    /** Returns the number of points of all rings that have been read. */
    int pointCount() {
        return pointCount;
    }

    /** Returns the points of all rings that have been read. */
    List<Vector2> points() {
        List<Vector2> points = new ArrayList<>(pointCount);
        for (int i = 0; i < pointCount; i++) {
            points.add(new Vector2(xs[i], ys[i]));
        }
        return points;
    }

    /** Returns the plan of all rings that have been read. */
    PlanShape plan() {
        return PlanShape.of(
                Arrays.copyOf(xs, pointCount), Arrays.copyOf(ys, pointCount), Arrays.copyOf(starts, ringCount + 1));
    }
}
