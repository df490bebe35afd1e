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
import java.util.stream.Collectors;

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
        obstacle.shape().accept(new ShapeWriter(obstacle, out));
        if (obstacle.isSpecular()) {
            out.angleAttribute("specular", obstacle.specularAngle());
        }
        if (obstacle.isMoving()) {
            writeMotion(obstacle.motion(), out);
        }
        out.endElement();
    }

    /** Begins the element of an obstacle and writes the attributes of its shape. */
    private record ShapeWriter(Obstacle obstacle, XmlWriter out) implements ObstacleShape.ShapeVisitor<XmlWriter> {

        private XmlWriter begin(String name) {
            return writePose(obstacle.pose(), out.beginElement(name).attribute("id", obstacle.id()));
        }

        @Override
        public XmlWriter visit(ObstacleShape.RectangleShape shape) {
            return begin("rectangle").attribute("width", shape.width()).attribute("height", shape.height());
        }

        @Override
        public XmlWriter visit(ObstacleShape.CircleShape shape) {
            return begin("circle").attribute("radius", shape.radius());
        }

        @Override
        public XmlWriter visit(ObstacleShape.EllipseShape shape) {
            return begin("ellipse").attribute("rx", shape.rx()).attribute("ry", shape.ry());
        }

        @Override
        public XmlWriter visit(ObstacleShape.PolygonShape shape) {
            return begin("polygon").attribute("points", formatPoints(shape.points()));
        }

        @Override
        public XmlWriter visit(ObstacleShape.WallShape shape) {
            return begin("wall").attribute("points", formatPoints(shape.points()));
        }

        @Override
        public XmlWriter visit(ObstacleShape.PlanShape shape) {
            String rings = shape.rings().stream().map(WorldWriter::formatPoints).collect(Collectors.joining(" | "));
            return begin("plan").attribute("points", rings);
        }
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
