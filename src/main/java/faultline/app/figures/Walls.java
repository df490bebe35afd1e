package faultline.app.figures;

import faultline.app.figures.Alignment.Place;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;

/** The walls that eq. (4) is tried at, and where the robot starts before them; variants come from another distance at another angle. */
final class Walls {

    private static final double MIDDLE = Alignment.WALL;
    private static final double LONG = 4;
    private static final double ALONG = 1.4;

    private Walls() {
    }

    /** A wall that no cone sees the end of. */
    static Place endless(double distance, int variant) {
        return ending(LONG, distance, variant);
    }

    /** A wall that ends a way ahead of the robot's foot point. */
    static Place ending(double ahead, double distance, int variant) {
        Obstacle wall = wall("wall", List.of(new Vec(MIDDLE - LONG, MIDDLE), new Vec(MIDDLE + ahead, MIDDLE)));
        double away = distance + 0.25 + 0.0137 * variant;
        double slant = Degrees.toRadians(2.0 * variant + 1);
        return Place.of(List.of(wall), new Pose(MIDDLE + away * StrictMath.tan(slant) * 0.5, MIDDLE - away, StrictMath.PI / 2 + slant));
    }

    /** An inner corner: the robot meets the one wall, follows it, and is then to align with the other, which lies on y = WALL. */
    static Place corner(double angle, double distance, int variant) {
        Vec corner = new Vec(MIDDLE, MIDDLE);
        Vec alongFirst = Vec.direction(-angle);
        Vec inward = alongFirst.perpendicular();
        Obstacle walls = wall("corner", List.of(corner.plus(alongFirst.times(LONG)), corner, corner.plus(new Vec(LONG, 0))));
        Vec start = corner.plus(alongFirst.times(ALONG + 0.0213 * variant)).plus(inward.times(distance + 0.3));
        return Place.of(List.of(walls), new Pose(start.x(), start.y(), inward.angle() + StrictMath.PI + Degrees.toRadians(2)));
    }

    private static Obstacle wall(String id, List<Vec> points) {
        return new Obstacle(id, new ObstacleShape.Wall(points), Pose.ORIGIN);
    }
}
