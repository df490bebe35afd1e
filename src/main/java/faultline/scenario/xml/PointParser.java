package faultline.scenario.xml;

import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.util.Optional;

/**
 * Parses points in the form of files: x,y pairs with blanks between the pairs. They are read one at a time, because a
 * hostile file may hold millions, and without a text of their own, because the plan of a building has tens of
 * thousands.
 */
final class PointParser {

    private static final double LEAST = NumberRange.COORDINATE.min().doubleValue();
    private static final double MOST = NumberRange.COORDINATE.max().doubleValue();

    private final char[] text;
    private final int length;
    private int begin;
    private int end;

    /** Creates a parser of the points in a part of a text. */
    PointParser(char[] text, int from, int length) {
        this.text = text;
        this.length = length;
        this.end = from;
    }

    /** Goes to the next pair, and returns false if there is none. */
    boolean advance() {
        begin = end;
        while (begin < length && isBlank(text[begin])) {
            begin++;
        }
        end = begin;
        while (end < length && !isBlank(text[end])) {
            end++;
        }
        return begin < length;
    }

    private static boolean isBlank(char c) {
        return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f';
    }

    /** Returns the present pair. */
    String pair() {
        return new String(text, begin, end - begin);
    }

    /** Returns the point of the present pair, empty if the pair is invalid. */
    Optional<Vector2> point() {
        int comma = begin;
        while (comma < end && text[comma] != ',') {
            comma++;
        }
        if (comma == end) {
            return Optional.empty();
        }
        double x = coordinate(begin, comma);
        double y = coordinate(comma + 1, end);
        return Double.isNaN(x) || Double.isNaN(y) ? Optional.empty() : Optional.of(new Vector2(x, y));
    }

    /** Returns the coordinate in a part of the text, NaN if it is invalid. */
    private double coordinate(int from, int to) {
        double rounded = DecimalText.parseShort(text, from, to);
        if (rounded > LEAST && rounded < MOST) {
            return rounded;
        }
        String number = new String(text, from, to - from);
        Optional<BigDecimal> exact = DecimalText.parse(number).filter(NumberRange.COORDINATE::contains);
        return exact.isPresent() ? DecimalText.toDouble(exact.get(), number) : Double.NaN;
    }
}
