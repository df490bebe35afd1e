package faultline.studies;

import faultline.control.Threshold;
import faultline.control.TimingRule;
import faultline.geometry.Angles;
import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.sensor.SensorSpec;
import faultline.world.ObstacleGeometry;
import java.util.List;

/**
 * The heading error of eq. (4) in theory. The left sensor sees the wall between two headings, the edges; for an endless
 * wall they lie at plus and minus the phi0 that solves R cos(max(0, phi0 - b)) + a cos(phi0) = D, with the range R,
 * half the cone b, the mounting offset a and the distance D from the centre to the wall. Turning back for half of the
 * time ends in their middle, which is parallel if the edges are symmetric. With the range rule the robot stops short of
 * the middle by the motors' lag and half a period. The edges are found numerically: by steps of the heading and by
 * bisection.
 */
record AlignmentTheory(AlignmentTrial trial, List<ConvexShape> walls, Vector2 position) {

    private static final double STEP = StrictMath.toRadians(0.05);
    private static final double NEAREST_RANGE = StrictMath.toRadians(20);
    private static final int BISECTION_STEPS = 40;

    static AlignmentTheory of(AlignmentTrial trial, Vector2 at) {
        List<ConvexShape> walls = trial.setup().world().obstacles().stream()
                .flatMap(obstacle -> ObstacleGeometry.of(obstacle).parts().stream())
                .toList();
        return new AlignmentTheory(trial, walls, at);
    }

    /** Returns the mean heading error at the first tick of FOLLOW, radians. */
    double headingError() {
        double late =
                trial.timing() == TimingRule.RANGE ? trial.robot().motor().timeConstant() + trial.period() / 2 : 0;
        return middleHeading() - trial.robot().turnRate() * late;
    }

    /**
     * Returns the greatest deviation of single trials from the mean, because a sample is up to one period late,
     * radians.
     */
    double spread() {
        return trial.timing() == TimingRule.RANGE ? trial.robot().turnRate() * trial.period() / 2 : 0;
    }

    /** Returns the middle between the two edges, radians from parallel. */
    private double middleHeading() {
        double level = edgeReading();
        return (edgeHeading(level, 1) + edgeHeading(level, -1)) / 2;
    }

    /**
     * Returns the reading at the edges: the range, or a little more than the nearest reading, unless the readings have
     * a maximum before.
     */
    double edgeReading() {
        if (trial.timing() == TimingRule.RANGE) {
            return leftSensor().range();
        }
        double nearest = nearestHeading();
        double level = readingAt(nearest) * (1 + Threshold.TIMING_LEVEL.defaultValue());
        return Math.min(level, Math.min(maxReading(nearest, level, 1), maxReading(nearest, level, -1)));
    }

    /**
     * Returns the heading of the nearest reading near parallel; it is not parallel itself if the axis misses the
     * centre.
     */
    private double nearestHeading() {
        double nearest = 0;
        for (double heading = -NEAREST_RANGE; heading < NEAREST_RANGE; heading += STEP) {
            nearest = readingAt(heading) < readingAt(nearest) ? heading : nearest;
        }
        return nearest;
    }

    /** Returns the farthest reading on one side of a heading before the readings fall again, up to a level. */
    private double maxReading(double from, double level, int side) {
        double last = readingAt(from);
        for (double turned = STEP; turned < StrictMath.PI; turned += STEP) {
            double next = readingAt(from + side * turned);
            if (next > level || next < last - 1e-9) {
                return Math.min(level, Math.max(last, next));
            }
            last = next;
        }
        return last;
    }

    /** Returns the heading at which the reading first reaches a level, turning from the nearest reading to one side. */
    double edgeHeading(double level, int side) {
        double from = nearestHeading();
        double seen = 0;
        while (readingAt(from + side * (seen + STEP)) < level && seen < 2 * StrictMath.PI) {
            seen += STEP;
        }
        double unseen = seen + STEP;
        for (int i = 0; i < BISECTION_STEPS; i++) {
            double middle = (seen + unseen) / 2;
            if (readingAt(from + side * middle) < level) {
                seen = middle;
            } else {
                unseen = middle;
            }
        }
        return from + side * seen;
    }

    /**
     * Returns the distance of the nearest point of the walls in the cone, in closed form: it is the foot of the
     * perpendicular, the end of a wall, or a point on an edge of the cone. The simulator's sensor is not used.
     */
    private double readingAt(double heading) {
        SensorSpec left = leftSensor();
        Vector2 apex = new Pose(position.x(), position.y(), heading).toParent(left.mountPosition());
        double axis = heading + left.bearing();
        double half = left.cone() / 2;
        double least = left.range() * (1 + 1e-12);
        double found = Double.POSITIVE_INFINITY;
        for (ConvexShape shape : walls) {
            Segment wall = (Segment) shape;
            Vector2 along = wall.b().minus(wall.a());
            double foot = apex.minus(wall.a()).dot(along) / along.dot(along);
            found = Math.min(found, distanceInCone(wall.a().plus(along.times(clamp(foot))), apex, axis, half));
            found = Math.min(
                    found,
                    Math.min(distanceInCone(wall.a(), apex, axis, half), distanceInCone(wall.b(), apex, axis, half)));
            found = Math.min(found, alongRay(wall, apex, axis - half));
            found = Math.min(found, alongRay(wall, apex, axis + half));
        }
        return found <= least ? found : Double.POSITIVE_INFINITY;
    }

    private static double clamp(double share) {
        return Math.max(0, Math.min(1, share));
    }

    /** Returns the distance of a point in the cone; infinite outside. */
    private static double distanceInCone(Vector2 point, Vector2 apex, double axis, double half) {
        Vector2 offset = point.minus(apex);
        return Math.abs(Angles.difference(axis, offset.angle())) <= half ? offset.length() : Double.POSITIVE_INFINITY;
    }

    /** Returns the distance at which a ray meets a wall; infinite if it does not. */
    private static double alongRay(Segment wall, Vector2 apex, double bearing) {
        Vector2 ray = Vector2.direction(bearing);
        Vector2 along = wall.b().minus(wall.a());
        double cross = ray.cross(along);
        double distance = wall.a().minus(apex).cross(along) / cross;
        double share = wall.a().minus(apex).cross(ray) / cross;
        return cross != 0 && distance >= 0 && share >= 0 && share <= 1 ? distance : Double.POSITIVE_INFINITY;
    }

    private SensorSpec leftSensor() {
        return trial.robot().sensor("left").orElseThrow();
    }
}
