package faultline.scenario;

import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.scenario.xml.NumberRange;
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
    /** The index after the present pair, and that of its first comma, negative if it has none. */
    private int end;

    private int comma;

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
        comma = -1;
        for (end = begin; end < length && (text[end] > ' ' || !isBlank(text[end])); end++) {
            if (text[end] == ',' && comma < 0) {
                comma = end;
            }
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

    /** Returns the point of the present pair, with a coordinate that is not a number if the pair is invalid. */
    Vector2 point() {
        return comma < 0
                ? new Vector2(Double.NaN, Double.NaN)
                : new Vector2(coordinate(begin, comma), coordinate(comma + 1, end));
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
