package faultline.scenario;

import faultline.io.DecimalText;
import faultline.io.XmlText;
import faultline.scenario.xml.NumberRange;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Reads points the plain way, with a text for each pair and an exact value for each number, as the judge of
 * {@link RingScanner}.
 */
final class PointsReference {

    /** The coordinates x, y, x, y and so on of each ring. */
    private final List<List<Double>> rings = new ArrayList<>();
    /** The text that is reported as invalid, or "too many". */
    private final List<String> problems = new ArrayList<>();

    private PointsReference() {}

    /** Reads the points of one ring. */
    static PointsReference ofPoints(String text, int least, int most) {
        PointsReference reference = new PointsReference();
        reference.addRing(text, least, most);
        return reference;
    }

    /** Reads the rings of a plan, up to the first that is invalid. */
    static PointsReference ofPlan(String text, int most) {
        PointsReference reference = new PointsReference();
        int left = most;
        for (String ring : text.split("\\|", -1)) {
            if (!reference.addRing(ring, 3, left)) {
                break;
            }
            left -= reference.rings.get(reference.rings.size() - 1).size() / 2;
        }
        return reference;
    }

    List<List<Double>> rings() {
        return rings;
    }

    List<String> problems() {
        return problems.stream().distinct().toList();
    }

    private boolean addRing(String ring, int least, int most) {
        List<Double> coordinates = new ArrayList<>();
        for (String pair : ring.split("[ \n\t\r\f]+")) {
            if (pair.isEmpty()) {
                continue;
            }
            if (coordinates.size() == 2 * most) {
                problems.add("too many");
                return false;
            }
            int comma = pair.indexOf(',');
            Optional<Double> x = coordinate(pair.substring(0, Math.max(0, comma)));
            Optional<Double> y = coordinate(pair.substring(comma + 1));
            if (x.isEmpty() || y.isEmpty()) {
                problems.add(pair);
                return false;
            }
            coordinates.add(x.get());
            coordinates.add(y.get());
        }
        if (coordinates.size() < 2 * least) {
            problems.add(XmlText.strip(ring));
            return false;
        }
        rings.add(coordinates);
        return true;
    }

    private static Optional<Double> coordinate(String number) {
        Optional<BigDecimal> exact = DecimalText.parse(number);
        return exact.filter(NumberRange.COORDINATE::contains).map(value -> DecimalText.toDouble(value, number));
    }
}
