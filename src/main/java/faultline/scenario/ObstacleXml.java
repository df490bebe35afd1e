package faultline.scenario;

import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.XmlComments;
import faultline.scenario.xml.XmlFormat;
import faultline.scenario.xml.XmlWriter;
import faultline.world.Obstacle;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Converts obstacles to and from the elements of a scenario file, for the clipboard. */
public final class ObstacleXml {

    private static final String PREFIX = "<scenario xmlns=\"" + XmlFormat.SCENARIO.namespace()
            + "\" name=\"\"><world width=\"1\" height=\"1\" enclosed=\"false\""
            + " maxMoving=\"" + ScenarioLimits.MAX_PARTS + "\">"
            // A message about a mistake must not quote the prefix; a line break would change the line numbers.
            + " ".repeat(ScenarioLimits.EXCERPT_LENGTH);
    /** A scenario must have a robot; this one is far away. */
    private static final String SUFFIX = "</world><robot x=\"-100000\" y=\"-100000\"/></scenario>";

    private ObstacleXml() {}

    /**
     * {@return obstacles as text, one element to a line, in order; those of moving obstacles contain their motions}
     *
     * @param obstacles the obstacles
     */
    public static String format(List<Obstacle> obstacles) {
        XmlWriter out = new XmlWriter(XmlComments.NONE);
        obstacles.forEach(obstacle -> WorldWriter.writeObstacle(obstacle, out));
        return out.toString().replaceFirst("^<\\?xml[^>]*>\\n", "");
    }

    /**
     * {@return the obstacles of a text in order}
     *
     * @param text elements as {@link #format} returns them, or a whole scenario
     * @throws ScenarioException with everything that is wrong
     */
    public static List<Obstacle> parse(String text) throws ScenarioException {
        String trimmed = text.replaceFirst("^\uFEFF", "").strip();
        String file = isScenario(trimmed) ? trimmed : PREFIX + trimmed + SUFFIX;
        return ScenarioReader.read("", file.getBytes(StandardCharsets.UTF_8))
                .setup()
                .world()
                .obstacles();
    }

    /** Returns whether a text is that of a scenario file, which may begin with comments. */
    private static boolean isScenario(String text) {
        int start = 0;
        while (text.startsWith("<!--", start)) {
            int end = text.indexOf("-->", start + "<!--".length());
            if (end < 0) {
                return false;
            }
            start = end + "-->".length();
            while (start < text.length() && Character.isWhitespace(text.charAt(start))) {
                start++;
            }
        }
        return text.startsWith("<?xml", start) || text.startsWith("<scenario", start);
    }
}
