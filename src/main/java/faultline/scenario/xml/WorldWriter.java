package faultline.scenario.xml;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.stream.Collectors;

/** Writes the world and obstacles. */
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
        ObstacleShape shape = obstacle.shape();
        if (shape instanceof ObstacleShape.Rectangle rectangle) {
            beginObstacle("rectangle", obstacle, out)
                    .attribute("width", rectangle.width())
                    .attribute("height", rectangle.height());
        } else if (shape instanceof ObstacleShape.Circle circle) {
            beginObstacle("circle", obstacle, out).attribute("radius", circle.radius());
        } else if (shape instanceof ObstacleShape.Ellipse ellipse) {
            beginObstacle("ellipse", obstacle, out)
                    .attribute("rx", ellipse.rx())
                    .attribute("ry", ellipse.ry());
        } else if (shape instanceof ObstacleShape.Polygon polygon) {
            beginObstacle("polygon", obstacle, out).attribute("points", formatPoints(polygon.points()));
        } else if (shape instanceof ObstacleShape.Wall wall) {
            beginObstacle("wall", obstacle, out).attribute("points", formatPoints(wall.points()));
        }
        if (obstacle.isSpecular()) {
            out.angleAttribute("specular", obstacle.specularAngle());
        }
        obstacle.motion().ifPresent(motion -> writeMotion(motion, out));
        out.endElement();
    }

    private static XmlWriter beginObstacle(String name, Obstacle obstacle, XmlWriter out) {
        return writePose(obstacle.pose(), out.beginElement(name).attribute("id", obstacle.id()));
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

    private static String formatPoints(List<Vector2> points) {
        return points.stream()
                .map(point -> DecimalText.format(point.x()) + "," + DecimalText.format(point.y()))
                .collect(Collectors.joining(" "));
    }
}
