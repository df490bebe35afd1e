package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Moves obstacles and robot through one tick together, exactly: everything goes on until the robot first touches
 * something, where the robot stops for good; a moving obstacle waits wherever going on would run into the robot.
 */
final class MotionStep {

    /**
     * The robot's contact with something.
     *
     * @param time within the tick, seconds
     * @param obstacle what it touches
     * @param points where, at least one
     */
    record Contact(double time, String obstacle, List<Vector2> points) {}

    private static final double NEVER = Double.POSITIVE_INFINITY;

    private final ObstacleSet obstacleSet;
    private final RobotBody body;
    private final CandidateBuffer candidates = new CandidateBuffer();
    private Optional<Contact> contact = Optional.empty();

    MotionStep(ObstacleSet field, RobotBody body) {
        this.obstacleSet = field;
        this.body = body;
    }

    /** The contact made since this was last asked. */
    Optional<Contact> pollContact() {
        Optional<Contact> taken = contact;
        contact = Optional.empty();
        return taken;
    }

    /** One tick. */
    void move(double dt) {
        TimeOfImpact rolling = body.timeOfImpact();
        double stop = staticContactTime(rolling, dt);
        for (int which = 0; which < obstacleSet.movingIndices().size(); which++) {
            stop = Math.min(stop, followerContactTime(rolling, which, dt));
        }
        double end = Math.min(stop, dt);
        Pose before = body.pose();
        body.advance(end);
        for (int which = 0; which < obstacleSet.movingIndices().size(); which++) {
            advance(which, end);
        }
        if (stop < NEVER) {
            body.stop();
            contact = Optional.of(contactAt(stop, before));
            advanceFollowersAfterContact(dt - end);
        }
    }

    private void advance(int which, double time) {
        obstacleSet.follower(which).advance(time);
        obstacleSet.updatePosition(which);
    }

    /** Lets every mover go on for the rest of a tick, or until it would run into the body at rest. */
    private void advanceFollowersAfterContact(double rest) {
        for (int which = 0; which < obstacleSet.movingIndices().size(); which++) {
            advance(which, Math.min(rest, followerContactTime(body.timeOfImpact(), which, rest)));
        }
    }

    private double staticContactTime(TimeOfImpact rolling, double dt) {
        if (body.wheelSpeeds().equals(WheelSpeeds.ZERO)) {
            return NEVER;
        }
        Pose pose = body.pose();
        candidates.clear();
        obstacleSet.findStaticNear(
                pose.x(), pose.y(), body.reachableRadius(dt) + TimeOfImpact.TOUCH_DISTANCE, candidates);
        double stop = NEVER;
        for (int i = 0; i < candidates.size(); i++) {
            stop = Math.min(
                    stop, rolling.firstContactTime(pose, candidates.shape(i), Vector2.ZERO, Math.min(stop, dt)));
        }
        return stop;
    }

    /** When within a time the body, which sets out now, meets a moving obstacle, which does too. */
    private double followerContactTime(TimeOfImpact sweep, int which, double time) {
        for (WaypointFollower.Leg leg : obstacleSet.follower(which).legs(time)) {
            Pose pose = sweep.poseAfter(body.pose(), leg.from());
            double contact = leg.from()
                    + firstContactTime(sweep, pose, which, leg.start(), leg.velocity(), leg.to() - leg.from());
            if (contact < NEVER) {
                return contact;
            }
        }
        // A mover that stands is only met by a body that rolls.
        return restingContactTime(sweep, which, time);
    }

    private double restingContactTime(TimeOfImpact sweep, int which, double to) {
        List<WaypointFollower.Leg> legs = obstacleSet.follower(which).legs(to);
        double arrived = legs.isEmpty() ? 0 : legs.get(legs.size() - 1).to();
        if (arrived >= to) {
            return NEVER;
        }
        Vector2 place = legs.isEmpty() ? obstacleSet.follower(which).position() : endOf(legs.get(legs.size() - 1));
        return arrived
                + firstContactTime(
                        sweep, sweep.poseAfter(body.pose(), arrived), which, place, Vector2.ZERO, to - arrived);
    }

    private static Vector2 endOf(WaypointFollower.Leg leg) {
        return leg.start().plus(leg.velocity().times(leg.to() - leg.from()));
    }

    private double firstContactTime(
            TimeOfImpact sweep, Pose pose, int which, Vector2 place, Vector2 velocity, double time) {
        ObstacleGeometry outline =
                obstacleSet.geometry(obstacleSet.movingIndices().get(which));
        double dx = place.x() - outline.frame().x();
        double dy = place.y() - outline.frame().y();
        double stop = NEVER;
        for (ConvexShape part : outline.parts()) {
            stop = Math.min(
                    stop, sweep.firstContactTime(pose, part.translated(dx, dy), velocity, Math.min(stop, time)));
        }
        return stop;
    }

    /** What the body touches now that it has rolled from a pose. */
    private Contact contactAt(double time, Pose before) {
        candidates.clear();
        obstacleSet.findNear(
                before.x(),
                before.y(),
                body.spec().boundingRadius() + body.pose().position().distanceTo(before.position()) + 1e-6,
                candidates);
        String obstacle = "";
        List<Vector2> points = new ArrayList<>();
        for (int i = 0; i < candidates.size(); i++) {
            List<Vector2> found = body.contactPoints(candidates.shape(i));
            if (!found.isEmpty() && (obstacle.isEmpty() || obstacle.equals(obstacleSet.idOf(candidates.owner(i))))) {
                obstacle = obstacleSet.idOf(candidates.owner(i));
                points.addAll(found);
            }
        }
        return new Contact(time, obstacle, distinct(points));
    }

    private static List<Vector2> distinct(List<Vector2> points) {
        List<Vector2> distinct = new ArrayList<>();
        for (Vector2 point : points) {
            if (distinct.stream().noneMatch(other -> other.distanceTo(point) < 1e-8)) {
                distinct.add(point);
            }
        }
        return distinct;
    }

    /**
     * Slides an obstacle straight from where it stands, turned already, to a place, until it touches the body at rest
     * in this moment.
     *
     * @param owner the obstacle's place in the field
     * @param target where it would overlap the body
     * @return false where it would overlap the body even before it is slid
     */
    boolean slideUntilContact(int owner, Pose target) {
        Vector2 from = obstacleSet.obstacles().get(owner).pose().position();
        Pose turned = new Pose(from.x(), from.y(), target.heading());
        ObstacleGeometry outline =
                ObstacleGeometry.of(obstacleSet.obstacles().get(owner).withPose(turned));
        if (!ObstacleSet.isClear(body.box(), outline)) {
            return false;
        }
        Vector2 way = target.position().minus(from);
        TimeOfImpact still = new TimeOfImpact(body.spec().length(), body.spec().width(), Velocity.ZERO);
        double stop = 1;
        for (ConvexShape part : outline.parts()) {
            stop = Math.min(stop, still.firstContactTime(body.pose(), part, way, stop));
        }
        Vector2 place = from.plus(way.times(stop));
        obstacleSet.move(owner, new Pose(place.x(), place.y(), target.heading()));
        body.stop();
        contact = Optional.of(contactAt(0, body.pose()));
        return true;
    }
}
