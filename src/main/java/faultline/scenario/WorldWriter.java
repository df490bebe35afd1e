package faultline.scenario;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Motion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.stream.Collectors;

/** Writes the world and obstacles. */
final class WorldWriter {

    private WorldWriter() {
    }

    static void world(WorldSpec world, XmlOut out) {
        out.begin("world").set("width", world.width()).set("height", world.height()).set("enclosed", world.enclosed())
                .set("maxMoving", String.valueOf(world.maxMoving()));
        world.obstacles().forEach(obstacle -> obstacle(obstacle, out));
        out.end();
    }

    static void obstacle(Obstacle obstacle, XmlOut out) {
        ObstacleShape shape = obstacle.shape();
        if (shape instanceof ObstacleShape.Rectangle rectangle) {
            placed("rectangle", obstacle, out).set("width", rectangle.width()).set("height", rectangle.height());
        } else if (shape instanceof ObstacleShape.Circle circle) {
            placed("circle", obstacle, out).set("radius", circle.radius());
        } else if (shape instanceof ObstacleShape.Ellipse ellipse) {
            placed("ellipse", obstacle, out).set("rx", ellipse.rx()).set("ry", ellipse.ry());
        } else if (shape instanceof ObstacleShape.Polygon polygon) {
            placed("polygon", obstacle, out).set("points", text(polygon.points()));
        } else if (shape instanceof ObstacleShape.Wall wall) {
            placed("wall", obstacle, out).set("points", text(wall.points()));
        }
        if (obstacle.isGlossy()) {
            out.setAngle("specular", obstacle.specular());
        }
        obstacle.motion().ifPresent(motion -> motion(motion, out));
        out.end();
    }

    private static XmlOut placed(String name, Obstacle obstacle, XmlOut out) {
        return pose(obstacle.pose(), out.begin(name).set("id", obstacle.id()));
    }

    static XmlOut pose(Pose pose, XmlOut out) {
        return out.set("x", pose.x()).set("y", pose.y()).setAngle("heading", pose.heading());
    }

    private static void motion(Motion motion, XmlOut out) {
        out.begin("motion").set("speed", motion.speed()).set("loop", motion.loop()).set("points", text(motion.points())).end();
    }

    private static String text(List<Vec> points) {
        return points.stream().map(point -> Numbers.toText(point.x()) + "," + Numbers.toText(point.y())).collect(Collectors.joining(" "));
    }
}
