package faultline.campaign;

import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Makes the visitors of a room: discs that move back and forth on a straight line, and always leave the width of a
 * passage between them and everything else.
 */
final class RandomVisitors {

    private static final int MAX_TRIES = 3000;
    private static final double SPACING = 0.05;

    /** The length of a visitor's path, metres. */
    private static final double MIN_LENGTH = 0.3;

    private static final double MAX_LENGTH = 4;

    private final RoomPlan plan;
    private final Vector2 start;
    private final SplittableRandom random;
    private final List<Obstacle> visitors = new ArrayList<>();
    private final List<Segment> lines = new ArrayList<>();

    /**
     * Creates a generator for a furnished room and the initial position of the robot. Visitors have separate random
     * numbers of the room's seed, so that they change nothing else in it.
     */
    RandomVisitors(RoomPlan plan, Vector2 start, long seed) {
        this.plan = plan;
        this.start = start;
        this.random = new SplittableRandom(~seed);
    }

    /** Returns at most a number of visitors, fewer if the room has no space for more. */
    List<Obstacle> make(int count) {
        for (int i = 0; i < MAX_TRIES && visitors.size() < count; i++) {
            double radius = random.nextDouble(0.1, 0.2);
            double speed = random.nextDouble(0.05, 0.3);
            Vector2 from = new Vector2(random.nextDouble(RandomRoom.SIZE), random.nextDouble(RandomRoom.SIZE));
            Vector2 along = Vector2.direction(random.nextDouble(2 * StrictMath.PI));
            Segment line = new Segment(from, from.plus(along.times(random.nextDouble(MIN_LENGTH, MAX_LENGTH))));
            if (isFree(line, radius)) {
                WaypointPath path = new WaypointPath(speed, true, List.of(line.b(), line.a()));
                Pose pose = new Pose(line.ax(), line.ay(), 0);
                lines.add(line);
                visitors.add(new Obstacle(
                        "visitor-" + (visitors.size() + 1), new ObstacleShape.CircleShape(radius), pose, path));
            }
        }
        return visitors;
    }

    private boolean isFree(Segment line, double radius) {
        int pieces = (int) Math.ceil(line.length() / SPACING);
        if (line.nearestTo(start).distanceTo(start) < RandomRoom.START_CLEARANCE + radius) {
            return false;
        }
        for (int i = 0; i <= pieces; i++) {
            Vector2 at = line.pointAt((double) i / pieces);
            if (!plan.surrounds(at)
                    || plan.distance(at) < RandomRoom.PASSAGE + radius + SPACING
                    || visitorDistance(at) < RandomRoom.PASSAGE + radius + SPACING) {
                return false;
            }
        }
        return true;
    }

    private double visitorDistance(Vector2 at) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < lines.size(); i++) {
            double radius = visitors.get(i).shape().boundingRadius();
            least = Math.min(least, lines.get(i).nearestTo(at).distanceTo(at) - radius);
        }
        return least;
    }
}
