package faultline.scenario.xml;

import faultline.world.Obstacle;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Obstacles as text: the elements that a scenario file has for them, ready to be put into one by hand. */
public final class ObstacleXml {

    private static final String PREFIX = "<scenario xmlns=\"" + ScenarioSchema.NAMESPACE
            + "\" name=\"\"><world width=\"1\" height=\"1\" enclosed=\"false\""
            + " maxMoving=\"" + ScenarioLimits.MAX_PARTS + "\">";
    /** The robot that a scenario must have, out of the way. */
    private static final String SUFFIX = "</world><robot x=\"-100000\" y=\"-100000\"/></scenario>";

    private ObstacleXml() {}

    /**
     * The text of obstacles.
     *
     * @param obstacles in order
     * @return one element a line, those of moving ones with their motions
     */
    public static String format(List<Obstacle> obstacles) {
        XmlWriter out = new XmlWriter();
        obstacles.forEach(obstacle -> WorldWriter.writeObstacle(obstacle, out));
        return out.toString().replaceFirst("^<\\?xml[^>]*>\\n", "");
    }

    /**
     * The obstacles of a text.
     *
     * @param text elements as {@link #format} makes them, or a whole scenario
     * @return its obstacles, in order
     * @throws ScenarioException with everything that is wrong
     */
    public static List<Obstacle> parse(String text) throws ScenarioException {
        String trimmed = text.strip();
        boolean whole = trimmed.startsWith("<?xml") || trimmed.startsWith("<scenario");
        String file = whole ? trimmed : PREFIX + trimmed + SUFFIX;
        return ScenarioReader.read("", file.getBytes(StandardCharsets.UTF_8))
                .setup()
                .world()
                .obstacles();
    }
}
