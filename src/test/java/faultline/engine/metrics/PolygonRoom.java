package faultline.engine.metrics;

import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;

/**
 * A ring of straight walls to walk along on its left side: counter-clockwise the inside of a room, clockwise the
 * outside of a free-standing thing.
 *
 * @param name says where it comes from, such as the seed
 * @param ring its corners in order, the last joined to the first
 * @param start where the robot starts
 */
record PolygonRoom(String name, List<Vector2> ring, Pose start) {

    private static final double SIZE = 12;

    PolygonRoom {
        ring = List.copyOf(ring);
    }

    PolygonRoom withStart(Pose newStart) {
        return new PolygonRoom(name, ring, newStart);
    }

    /** The world with nothing but this ring in it. */
    WorldSpec world() {
        return new WorldSpec(SIZE, SIZE, false, 3, List.of(wall()));
    }

    Obstacle wall() {
        List<Vector2> points = new ArrayList<>(ring);
        points.add(ring.get(0));
        return new Obstacle("walls", new ObstacleShape.WallShape(points), Pose.ORIGIN);
    }

    Vector2 corner(int i) {
        return ring.get(Math.floorMod(i, ring.size()));
    }

    /** The mean of its corners. */
    Vector2 centroid() {
        return ring.stream().reduce(Vector2.ZERO, Vector2::plus).times(1.0 / ring.size());
    }

    /**
     * How the wall turns at a corner, radians: positive where it juts in (an inner corner of pi less this), negative
     * where it juts out.
     */
    double turn(int i) {
        return Angles.difference(
                corner(i).minus(corner(i - 1)).angle(),
                corner(i + 1).minus(corner(i)).angle());
    }

    /**
     * The straight piece of way beside the wall from corner i, at a distance from it, metres; less than 0 where it is
     * too short for its inner corners.
     */
    double straightLength(int i, double offset) {
        return corner(i).distanceTo(corner(i + 1)) - cornerCutOff(turn(i), offset) - cornerCutOff(turn(i + 1), offset);
    }

    private static double cornerCutOff(double turn, double offset) {
        return Math.max(0, offset * Math.tan(turn / 2));
    }

    /** The whole way round, metres. */
    double perimeter(double offset) {
        double way = 0;
        for (int i = 0; i < ring.size(); i++) {
            way += straightLength(i, offset) + Math.max(0, -turn(i) * offset);
        }
        return way;
    }

    /**
     * The time of a perfect lap, seconds: straights at the speed, inner corners at the turn rate, arcs about outer
     * corners at what allows both.
     */
    double lapTime(RobotSpec robot, double offset) {
        double time = 0;
        for (int i = 0; i < ring.size(); i++) {
            double turning = Math.abs(turn(i)) / robot.turnRate();
            double arc = Math.max(0, -turn(i)) * offset / robot.speed();
            time += straightLength(i, offset) / robot.speed() + Math.max(turning, arc);
        }
        return time;
    }

    boolean surrounds(Vector2 point) {
        boolean inside = false;
        for (int i = 0; i < ring.size(); i++) {
            Vector2 a = corner(i);
            Vector2 b = corner(i + 1);
            boolean crosses = a.y() > point.y() != b.y() > point.y();
            inside ^= crosses && point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        }
        return inside;
    }

    /** The distance of the nearest wall, metres. */
    double distance(Vector2 point) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ring.size(); i++) {
            Vector2 side = corner(i + 1).minus(corner(i));
            double share = Math.max(0, Math.min(1, point.minus(corner(i)).dot(side) / side.dot(side)));
            least = Math.min(least, point.distanceTo(corner(i).plus(side.times(share))));
        }
        return least;
    }

    /** Enough to replay it. */
    @Override
    public String toString() {
        return name + ", start " + start + ", ring " + ring;
    }
}
