package faultline.scenario.xml;

import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.util.Optional;
import java.util.StringTokenizer;

/**
 * Parses points in the form of files: x,y pairs with blanks between the pairs. They are read one at a time, because a
 * hostile file may hold millions.
 */
final class PointParser {

    private final StringTokenizer pairs;

    PointParser(String text) {
        pairs = new StringTokenizer(text);
    }

    boolean hasNext() {
        return pairs.hasMoreTokens();
    }

    String next() {
        return pairs.nextToken();
    }

    /** Returns the point of a pair, empty if the pair is invalid. */
    static Optional<Vector2> parsePoint(String pair) {
        int comma = pair.indexOf(',');
        if (comma < 0) {
            return Optional.empty();
        }
        return parseCoordinate(pair.substring(0, comma))
                .flatMap(x -> parseCoordinate(pair.substring(comma + 1)).map(y -> new Vector2(x, y)));
    }

    private static Optional<Double> parseCoordinate(String text) {
        double rounded = DecimalText.parseShort(text);
        if (NumberRange.COORDINATE.isInside(rounded)) {
            return Optional.of(rounded);
        }
        Optional<BigDecimal> exact = DecimalText.parse(text).filter(NumberRange.COORDINATE::contains);
        return exact.map(number -> DecimalText.toDouble(number, text));
    }
}
