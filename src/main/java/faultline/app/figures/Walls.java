package faultline.app.figures;

import faultline.engine.Setup;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.ObstacleShape;
import java.util.List;

/** The walls that eq. (4) is tried at, and where the robot starts before them; variants come from another distance at another angle. */
final class Walls {

    private static final double MIDDLE = Alignment.WALL;
    private static final double LONG = 4;
    private static final double ALONG = 1.4;

    private Walls() {
    }

    /** The file's wall, which no cone sees the end of. */
    static Setup endless(Setup base, double distance, int variant) {
        double away = distance + 0.25 + 0.0137 * variant;
        double slant = Degrees.toRadians(2.0 * variant + 1);
        return base.withStart(new Pose(MIDDLE + away * StrictMath.tan(slant) * 0.5, MIDDLE - away, StrictMath.PI / 2 + slant));
    }

    /** A wall that ends a way ahead of the robot's foot point. */
    static Setup ending(Setup base, double ahead, double distance, int variant) {
        List<Vec> points = List.of(new Vec(MIDDLE - LONG, MIDDLE), new Vec(MIDDLE + ahead, MIDDLE));
        return Variation.of(endless(base, distance, variant), Variation.obstacle(base, "wall").shaped(new ObstacleShape.Wall(points)));
    }

    /** An inner corner: the robot meets the one wall, follows it, and is then to align with the other, which lies on y = WALL. */
    static Setup corner(Setup base, double angle, double distance, int variant) {
        Vec corner = new Vec(MIDDLE, MIDDLE);
        Vec alongFirst = Vec.direction(-angle);
        Vec inward = alongFirst.perpendicular();
        List<Vec> points = List.of(corner.plus(alongFirst.times(LONG)), corner, corner.plus(new Vec(LONG, 0)));
        Vec start = corner.plus(alongFirst.times(ALONG + 0.0213 * variant)).plus(inward.times(distance + 0.3));
        Setup bent = Variation.of(base, Variation.obstacle(base, "corner").shaped(new ObstacleShape.Wall(points)));
        return bent.withStart(new Pose(start.x(), start.y(), inward.angle() + StrictMath.PI + Degrees.toRadians(2)));
    }
}
