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
import java.util.ArrayList;
import java.util.List;

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

    /**
     * Creates a reader.
     *
     * @param node the element
     * @param fields the reader of its attributes
     * @param problems the list to which problems are added
     * @param most the greatest number of points allowed
     */
    PointListReader(XmlElement node, AttributeReader fields, Problems problems, int most) {
        this.node = node;
        this.fields = fields;
        this.problems = problems;
        this.most = most;
    }

    /** Returns the points, of which the file must have at least some; they are written as "x,y x,y". */
    List<Vector2> points(int least) {
        Message allowed = Allowed.POINTS.with(least, NumberRange.COORDINATE.rule());
        return fields.requiredText(NAME, allowed)
                .map(text -> points(text.toCharArray(), 0, text.length(), least, Math.max(least, most), allowed))
                .orElse(PLACEHOLDER);
    }

    /** Returns the closed rings, separated by {@code |}, the points of each written as those of {@link #points}. */
    List<List<Vector2>> rings() {
        Message allowed = Allowed.RINGS.with(NumberRange.COORDINATE.rule());
        String text = fields.requiredText(NAME, allowed).orElse("0,0 1,0 0,1");
        char[] characters = text.toCharArray();
        List<List<Vector2>> rings = new ArrayList<>();
        int left = Math.max(3, most);
        for (int from = 0; from <= text.length(); ) {
            int bar = text.indexOf('|', from);
            int end = bar < 0 ? text.length() : bar;
            List<Vector2> ring = points(characters, from, end, 3, left, allowed);
            if (ring == PLACEHOLDER) {
                return List.of(PLACEHOLDER);
            }
            rings.add(ring);
            left -= ring.size();
            from = end + 1;
        }
        return rings;
    }

    /** Returns the points in a part of a text, {@link #PLACEHOLDER} if they are invalid or too few. */
    private List<Vector2> points(char[] text, int from, int end, int least, int left, Message allowed) {
        PointParser pairs = new PointParser(text, from, end);
        List<Vector2> points = new ArrayList<>();
        boolean more = pairs.advance();
        while (more && points.size() < left) {
            Vector2 point = pairs.point();
            if (!point.isFinite()) {
                fields.report(NAME, pairs.pair(), allowed);
                return PLACEHOLDER;
            }
            points.add(point);
            more = pairs.advance();
        }
        if (more) {
            problems.add(node, ProblemKind.TOO_MANY_POINTS.with(NAME, node.name(), ScenarioLimits.MAX_PARTS));
        }
        if (points.size() < least) {
            fields.report(NAME, XmlText.strip(new String(text, from, end - from)), allowed);
            return PLACEHOLDER;
        }
        return points;
    }
}
