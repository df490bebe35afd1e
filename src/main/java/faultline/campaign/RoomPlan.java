package faultline.campaign;

import faultline.geometry.EvenOddRule;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.ArrayList;
import java.util.List;

/** A room that is being furnished: the positions of its obstacles and the distances between them. */
final class RoomPlan {

    /**
     * The distance between the points at which outlines are compared, metres. A point is up to half of it aside from
     * the nearest place of a side, so a distance of 0.45 m seems at most 0.7 mm longer than it is.
     */
    private static final double SPACING = 0.05;

    private final List<Vector2> ring;
    private final List<Item> items = new ArrayList<>();

    /**
     * An item in a room: the corners of its outline, or its centre; the radius about these points, metres; and the wall
     * that it touches, -1 if it touches none.
     */
    record Item(Obstacle obstacle, List<Vector2> outline, double radius, int wall) {

        List<Vector2> points() {
            List<Vector2> points = new ArrayList<>();
            for (int i = 0; i < outline.size(); i++) {
                Vector2 from = outline.get(i);
                Vector2 side = outline.get((i + 1) % outline.size()).minus(from);
                int pieces = Math.max(1, (int) Math.ceil(side.length() / SPACING));
                for (int k = 0; k < pieces; k++) {
                    points.add(from.plus(side.times((double) k / pieces)));
                }
            }
            return points;
        }
    }

    RoomPlan(List<Vector2> ring) {
        this.ring = ring;
    }

    int walls() {
        return ring.size();
    }

    /** Returns the direction of a wall; the room is on its left. */
    Vector2 along(int wall) {
        Vector2 side = corner(wall + 1).minus(corner(wall));
        return side.times(1 / side.length());
    }

    Vector2 pointOn(int wall, double share) {
        return corner(wall).plus(corner(wall + 1).minus(corner(wall)).times(share));
    }

    private Vector2 corner(int i) {
        return ring.get(Math.floorMod(i, ring.size()));
    }

    /** Adds an item if it leaves all passages wide enough. */
    boolean add(Item item) {
        for (Vector2 point : item.points()) {
            boolean inside = item.wall() >= 0 ? wallDistance(point, -1) < 1e-9 || surrounds(point) : surrounds(point);
            if (!inside
                    || wallDistance(point, item.wall()) < RandomRoom.PASSAGE + item.radius()
                    || itemDistance(point) < RandomRoom.PASSAGE + item.radius()) {
                return false;
            }
        }
        items.add(item);
        return true;
    }

    /** Returns the distance from a point to the nearest wall other than a given one. */
    private double wallDistance(Vector2 point, int except) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ring.size(); i++) {
            if (i != except) {
                least = Math.min(least, distance(point, corner(i), corner(i + 1)));
            }
        }
        return least;
    }

    private double itemDistance(Vector2 point) {
        double least = Double.POSITIVE_INFINITY;
        for (Item item : items) {
            for (Vector2 other : item.points()) {
                least = Math.min(least, point.distanceTo(other) - item.radius());
            }
        }
        return least;
    }

    /** Returns the distance from a point to the nearest wall or item. */
    double distance(Vector2 point) {
        return Math.min(wallDistance(point, -1), itemDistance(point));
    }

    static double distance(Vector2 point, Vector2 a, Vector2 b) {
        Vector2 side = b.minus(a);
        double share = Math.max(0, Math.min(1, point.minus(a).dot(side) / side.dot(side)));
        return point.distanceTo(a.plus(side.times(share)));
    }

    /** Returns whether a point is inside the ring and outside all items. */
    boolean surrounds(Vector2 point) {
        return EvenOddRule.isInside(ring, point)
                && items.stream()
                        .noneMatch(item -> item.outline().size() > 1 && EvenOddRule.isInside(item.outline(), point));
    }

    /** Returns the walls and all items. */
    List<Obstacle> obstacles() {
        List<Obstacle> obstacles = new ArrayList<>();
        List<Vector2> closed = new ArrayList<>(ring);
        closed.add(ring.get(0));
        obstacles.add(new Obstacle("walls", new ObstacleShape.WallShape(closed), new Pose(0, 0, 0)));
        items.forEach(item -> obstacles.add(item.obstacle()));
        return obstacles;
    }
}
