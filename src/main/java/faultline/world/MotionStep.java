package faultline.world;

import faultline.geometry.BoxDistance;
import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.Separation;
import faultline.geometry.Vector2;
import faultline.robot.Velocity;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Moves obstacles and robot together through one tick, exactly, until the robot first touches something. At the first
 * contact the robot stops permanently. A moving obstacle waits while its path leads into the robot.
 */
final class MotionStep {

    /**
     * The robot's contact with something.
     *
     * @param time within the tick, seconds
     * @param obstacle the id of what it touches
     * @param points the contact points, at least one
     */
    record Contact(double time, String obstacle, List<Vector2> points) {}

    /** Points with at least a distance between them. Those in other cells than a point and its neighbours are far. */
    static final class DistinctPoints {
        private static final double MIN_DISTANCE = 1e-8;
        /** Twice the distance, so that rounding does not make a neighbour of a neighbour near. */
        private static final double CELL_SIZE = 2 * MIN_DISTANCE;

        private record PointCell(long column, long row) {}

        private final List<Vector2> points = new ArrayList<>();
        private final Map<PointCell, List<Vector2>> cells = new HashMap<>();

        /** Returns the points in the order in which they were added. */
        List<Vector2> points() {
            return points;
        }

        /** Adds a point if it is not too near to one that was added before. */
        void add(Vector2 point) {
            long column = (long) Math.floor(point.x() / CELL_SIZE);
            long row = (long) Math.floor(point.y() / CELL_SIZE);
            for (int i = 0; i < 9; i++) {
                PointCell near = new PointCell(column + i % 3 - 1, row + i / 3 - 1);
                for (Vector2 other : cells.getOrDefault(near, List.of())) {
                    if (other.distanceTo(point) < MIN_DISTANCE) {
                        return;
                    }
                }
            }
            cells.computeIfAbsent(new PointCell(column, row), cell -> new ArrayList<>(1))
                    .add(point);
            points.add(point);
        }
    }

    private static final double NEVER = Double.POSITIVE_INFINITY;

    /** A collision names an obstacle that is at most this far away, metres. */
    private static final double NAMING_TOLERANCE = 1e-6;

    private final ObstacleSet obstacles;
    private final RobotBody body;
    private final FreeTravel freeTravel;
    private final CandidateBuffer candidates = new CandidateBuffer();
    private final List<Contact> contacts = new ArrayList<>();
    /** Whether the first contact has been polled, after which no other is wanted. */
    private boolean collided;

    MotionStep(ObstacleSet obstacles, RobotBody body) {
        this.obstacles = obstacles;
        this.body = body;
        this.freeTravel = new FreeTravel(obstacles);
    }

    /** Must be called after the body's size has changed. */
    void bodyChanged() {
        freeTravel.invalidate();
    }

    /** Returns whether the robot has touched something, so that it may still touch it. */
    boolean hasCollided() {
        return collided || !contacts.isEmpty();
    }

    /** Returns the first contact of the run, once, after it was made. */
    Optional<Contact> pollContact() {
        if (contacts.isEmpty()) {
            return Optional.empty();
        }
        Contact first = contacts.get(0);
        contacts.clear();
        collided = true;
        return Optional.of(first);
    }

    /** Moves everything by one tick. */
    void move(double dt) {
        double stop = body.isAtRest() || freeTravel.take(body, dt) ? NEVER : staticContactTime(dt);
        List<MovingObstacle> moving = obstacles.moving();
        for (int i = 0; i < moving.size(); i++) {
            stop = Math.min(stop, movingContactTime(moving.get(i), dt));
        }
        if (stop < NEVER) {
            moveToContact(stop, dt);
            return;
        }
        body.advance(dt);
        for (int i = 0; i < moving.size(); i++) {
            moving.get(i).follower().advance(dt);
        }
    }

    /** Moves everything to the time of first contact, and then the obstacles that are not blocked. */
    private void moveToContact(double stop, double dt) {
        double end = Math.min(stop, dt);
        Pose before = body.pose();
        body.advance(end);
        obstacles.moving().forEach(mover -> mover.follower().advance(end));
        body.stop();
        addContact(stop, before);
        for (MovingObstacle mover : obstacles.moving()) {
            mover.follower().advance(Math.min(dt - end, movingContactTime(mover, dt - end)));
        }
    }

    private double staticContactTime(double dt) {
        TimeOfImpact impact = body.timeOfImpact();
        Pose pose = body.pose();
        candidates.clear();
        obstacles.findStaticNear(
                pose.x(), pose.y(), body.reachableRadius(dt) + TimeOfImpact.TOUCH_DISTANCE, candidates);
        double stop = NEVER;
        for (int i = 0; i < candidates.size(); i++) {
            stop = Math.min(stop, impact.firstContactTime(pose, candidates.shape(i), Vector2.ZERO, Math.min(stop, dt)));
        }
        return stop;
    }

    /** Returns when within a time the body meets a moving obstacle, both starting now. */
    private double movingContactTime(MovingObstacle mover, double time) {
        double reach = body.reachableRadius(time) + mover.follower().speed() * time + NAMING_TOLERANCE;
        if (!mover.isWithin(body.x(), body.y(), reach)) {
            return NEVER;
        }
        TimeOfImpact impact = body.timeOfImpact();
        Pose start = body.pose();
        Vector2 end = new Vector2(mover.follower().x(), mover.follower().y());
        double arrival = 0;
        for (WaypointFollower.Leg leg : mover.follower().legs(time)) {
            Pose pose = impact.poseAfter(start, leg.from());
            double contact = leg.from()
                    + firstContactTime(impact, pose, mover, leg.start(), leg.velocity(), leg.to() - leg.from());
            if (contact < NEVER) {
                return contact;
            }
            end = leg.start().plus(leg.velocity().times(leg.to() - leg.from()));
            arrival = leg.to();
        }
        // An obstacle that has stopped is met only by a body that moves.
        return arrival >= time
                ? NEVER
                : arrival
                        + firstContactTime(
                                impact, impact.poseAfter(start, arrival), mover, end, Vector2.ZERO, time - arrival);
    }

    private static double firstContactTime(
            TimeOfImpact impact, Pose pose, MovingObstacle mover, Vector2 position, Vector2 velocity, double time) {
        ObstacleGeometry geometry = mover.geometry();
        double dx = position.x() - geometry.frame().x();
        double dy = position.y() - geometry.frame().y();
        double stop = NEVER;
        for (ConvexShape part : geometry.parts()) {
            stop = Math.min(
                    stop, impact.firstContactTime(pose, part.translated(dx, dy), velocity, Math.min(stop, time)));
        }
        return stop;
    }

    /** Adds a contact if it is the first one: an obstacle that presses on the robot touches it in every tick. */
    private void addContact(double time, Pose before) {
        if (!collided) {
            contacts.add(contactAt(time, before));
        }
    }

    /** Returns what the body touches after moving from a pose: of several obstacles the first static one. */
    private Contact contactAt(double time, Pose before) {
        candidates.clear();
        double moved = body.pose().position().distanceTo(before.position());
        obstacles.findNear(before.x(), before.y(), body.boundingRadius() + moved + NAMING_TOLERANCE, candidates);
        List<ShapeOwner> owners = IntStream.range(0, candidates.size())
                .mapToObj(candidates::owner)
                .distinct()
                .sorted(Comparator.comparing((ShapeOwner owner) -> owner instanceof MovingObstacle)
                        .thenComparing(ShapeOwner::order))
                .toList();
        for (ShapeOwner owner : owners) {
            List<Vector2> points = contactPoints(owner);
            if (!points.isEmpty()) {
                return new Contact(time, owner.id(), points);
            }
        }
        return nearestContact(time);
    }

    /** Returns the distinct points where the body touches the shapes of an owner, in the order of the shapes. */
    private List<Vector2> contactPoints(ShapeOwner owner) {
        DistinctPoints distinct = new DistinctPoints();
        for (ConvexShape shape : shapesOf(owner)) {
            body.contactPoints(shape).forEach(distinct::add);
        }
        return distinct.points();
    }

    private List<ConvexShape> shapesOf(ShapeOwner owner) {
        if (owner instanceof PlacedObstacle obstacle) {
            return obstacle.parts();
        }
        return IntStream.range(0, candidates.size())
                .filter(i -> candidates.owner(i) == owner)
                .mapToObj(candidates::shape)
                .toList();
    }

    /** Returns the contact with the nearest shape, if rounding has left a gap. */
    private Contact nearestContact(double time) {
        String nearest = "";
        Separation least = new Separation(NAMING_TOLERANCE, Vector2.ZERO, Vector2.ZERO);
        for (int i = 0; i < candidates.size(); i++) {
            Separation gap = BoxDistance.between(body.box(), candidates.shape(i));
            if (gap.distance() < least.distance()) {
                least = gap;
                nearest = candidates.owner(i).id();
            }
        }
        if (nearest.isEmpty()) {
            throw new World.UnresolvedContactException(
                    "a contact was found, but nothing is within 1e-6 m of the robot");
        }
        return new Contact(time, nearest, List.of(least.onShape()));
    }

    /**
     * Slides an obstacle, already rotated, along a straight line to a pose at which it would overlap the body, until it
     * touches the body. The body is at rest during this motion. Returns false, and moves nothing, if they overlap
     * before the obstacle slides, or if rounding hides where they touch.
     */
    boolean slideUntilContact(PlacedObstacle placed, Pose target) {
        Pose start = placed.obstacle().pose();
        Vector2 from = start.position();
        ObstacleGeometry geometry = ObstacleGeometry.of(placed.obstacle().withPose(target.withPosition(from)));
        if (!ObstacleSet.isClear(body.box(), geometry)) {
            return false;
        }
        Vector2 displacement = target.position().minus(from);
        double stop = slideTime(geometry, displacement);
        if (stop == NEVER) {
            return false;
        }
        obstacles.move(placed, target.withPosition(from.plus(displacement.times(stop))));
        body.stop();
        contacts.clear();
        addContact(0, body.pose());
        return true;
    }

    /**
     * Returns the share of a displacement, at the end of which an obstacle overlaps the body, after which it touches
     * the body; positive infinity if only its inside overlaps.
     */
    private double slideTime(ObstacleGeometry geometry, Vector2 displacement) {
        TimeOfImpact still = new TimeOfImpact(body.spec().length(), body.spec().width(), Velocity.ZERO);
        double stop = NEVER;
        for (ConvexShape part : geometry.parts()) {
            stop = Math.min(stop, still.slideContactTime(body.pose(), part, displacement, Math.min(stop, 1)));
        }
        return stop;
    }
}
