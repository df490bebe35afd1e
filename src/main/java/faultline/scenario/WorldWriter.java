package faultline.scenario;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.scenario.xml.XmlWriter;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.function.Function;

/** Writes the world and its obstacles. */
final class WorldWriter {

    private WorldWriter() {}

    static void write(WorldSpec world, XmlWriter out) {
        out.beginElement("world")
                .attribute("width", world.width())
                .attribute("height", world.height())
                .attribute("enclosed", world.enclosed())
                .attribute("maxMoving", String.valueOf(world.maxMoving()));
        world.obstacles().forEach(obstacle -> writeObstacle(obstacle, out));
        out.endElement();
    }

    static void writeObstacle(Obstacle obstacle, XmlWriter out) {
        beginObstacle(obstacle, out);
        if (obstacle.isSpecular()) {
            out.angleAttribute("specular", obstacle.specularAngle());
        }
        if (obstacle.isMoving()) {
            writeMotion(obstacle.motion(), out);
        }
        out.endElement();
    }

    /** Begins the element of an obstacle and writes the attributes of its shape. */
    private static XmlWriter beginObstacle(Obstacle obstacle, XmlWriter out) {
        Function<String, XmlWriter> begin =
                name -> writePose(obstacle.pose(), out.beginElement(name).attribute("id", obstacle.id()));
        return obstacle.shape()
                .match(new ObstacleShape.ShapeCases<>(
                        rectangle -> begin.apply("rectangle")
                                .attribute("width", rectangle.width())
                                .attribute("height", rectangle.height()),
                        circle -> begin.apply("circle").attribute("radius", circle.radius()),
                        ellipse -> begin.apply("ellipse")
                                .attribute("rx", ellipse.rx())
                                .attribute("ry", ellipse.ry()),
                        polygon -> begin.apply("polygon").attribute("points", formatPoints(polygon.points())),
                        wall -> begin.apply("wall").attribute("points", formatPoints(wall.points())),
                        plan -> begin.apply("plan").attribute("points", formatRings(plan.rings()))));
    }

    static XmlWriter writePose(Pose pose, XmlWriter out) {
        return out.attribute("x", pose.x()).attribute("y", pose.y()).angleAttribute("heading", pose.heading());
    }

    private static void writeMotion(WaypointPath motion, XmlWriter out) {
        out.beginElement("motion")
                .attribute("speed", motion.speed())
                .attribute("loop", motion.loop())
                .attribute("points", formatPoints(motion.waypoints()))
                .endElement();
    }

    private static String formatRings(List<List<Vector2>> rings) {
        StringBuilder text = new StringBuilder();
        for (List<Vector2> ring : rings) {
            text.append(text.isEmpty() ? "" : " | ");
            appendPoints(ring, text);
        }
        return text.toString();
    }

    private static String formatPoints(List<Vector2> points) {
        StringBuilder text = new StringBuilder();
        appendPoints(points, text);
        return text.toString();
    }

    private static void appendPoints(List<Vector2> points, StringBuilder text) {
        String separator = "";
        for (Vector2 point : points) {
            text.append(separator)
                    .append(DecimalText.format(point.x()))
                    .append(',')
                    .append(DecimalText.format(point.y()));
            separator = " ";
        }
    }
}
