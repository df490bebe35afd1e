package faultline.scenario;

import faultline.geometry.Vector2;
import faultline.io.Message;
import faultline.io.XmlText;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.XmlElement;
import faultline.world.ObstacleShape.PlanShape;
import java.util.List;
import java.util.Optional;

/**
 * Reads the attribute {@code points} of one element. Points that cannot be read are reported and replaced by a valid
 * outline, like the placeholders of {@link AttributeReader}.
 */
final class PointListReader {

    private static final String NAME = "points";
    private static final List<Vector2> PLACEHOLDER = List.of(Vector2.ZERO, new Vector2(1, 0), new Vector2(0, 1));

    private final XmlElement node;
    private final AttributeReader fields;
    private final Problems problems;
    private final int most;

    /** Creates a reader of an element's points, up to a greatest number. */
    PointListReader(XmlElement node, AttributeReader fields, Problems problems, int most) {
        this.node = node;
        this.fields = fields;
        this.problems = problems;
        this.most = most;
    }

    /** Returns the points, of which the file must have at least some; they are written as "x,y x,y". */
    List<Vector2> points(int least) {
        Message allowed = Allowed.POINTS.with(least, NumberRange.COORDINATE.rule());
        Optional<String> text = fields.requiredText(NAME, allowed);
        if (text.isPresent()) {
            RingScanner scanner = new RingScanner(text.get(), false);
            if (isRingValid(scanner, least, Math.max(least, most), allowed)) {
                return scanner.points();
            }
        }
        return PLACEHOLDER;
    }

    /** Returns the plan of closed rings, separated by {@code |}, each written as {@link #points}. */
    PlanShape plan() {
        Message allowed = Allowed.RINGS.with(NumberRange.COORDINATE.rule());
        Optional<String> text = fields.requiredText(NAME, allowed);
        if (text.isPresent()) {
            RingScanner scanner = new RingScanner(text.get(), true);
            if (areRingsValid(scanner, Math.max(3, most), allowed)) {
                return scanner.plan();
            }
        }
        return new PlanShape(List.of(PLACEHOLDER));
    }

    private boolean areRingsValid(RingScanner scanner, int limit, Message allowed) {
        do {
            if (!isRingValid(scanner, 3, limit - scanner.pointCount(), allowed)) {
                return false;
            }
        } while (scanner.advance());
        return true;
    }

    /** Scans the next ring, and returns false, with a problem, if it is invalid or has too few or too many points. */
    private boolean isRingValid(RingScanner scanner, int least, int left, Message allowed) {
        int count = scanner.scanRing(left);
        if (!scanner.isRingRead() && count < left) {
            fields.report(NAME, scanner.pair(), allowed);
            return false;
        }
        if (!scanner.isRingRead()) {
            problems.add(node, ProblemKind.TOO_MANY_POINTS.with(NAME, node.name(), ScenarioLimits.MAX_PARTS));
            return false;
        }
        if (count < least) {
            fields.report(NAME, XmlText.strip(scanner.ring()), allowed);
            return false;
        }
        return true;
    }
}
