package faultline.scenario;

import faultline.geometry.Vec;
import java.math.BigDecimal;
import java.util.Optional;
import java.util.StringTokenizer;

/**
 * Points as files write them: x,y pairs with blanks between the pairs. They are taken one at a time, because a hostile file may have
 * millions.
 */
final class PointText {

    private final StringTokenizer pairs;

    PointText(String text) {
        pairs = new StringTokenizer(text);
    }

    boolean hasNext() {
        return pairs.hasMoreTokens();
    }

    String next() {
        return pairs.nextToken();
    }

    /** The point of one pair, empty where it is none. */
    static Optional<Vec> point(String pair) {
        int comma = pair.indexOf(',');
        if (comma < 0) {
            return Optional.empty();
        }
        return coordinate(pair.substring(0, comma)).flatMap(x -> coordinate(pair.substring(comma + 1)).map(y -> new Vec(x, y)));
    }

    private static Optional<Double> coordinate(String text) {
        Optional<BigDecimal> exact = Numbers.parse(text).filter(Range.COORDINATE::contains);
        return exact.map(number -> Numbers.toDouble(number, text));
    }
}
