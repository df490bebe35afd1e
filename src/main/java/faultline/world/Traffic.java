package faultline.world;

import faultline.geometry.Convex;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Moves obstacles and robot through one tick together, exactly: everything goes on until the robot first touches something, where the robot
 * stops for good; a moving obstacle waits wherever going on would run into the robot.
 */
final class Traffic {

    /**
     * The robot's contact with something.
     *
     * @param time within the tick, seconds
     * @param obstacle what it touches
     * @param points where, at least one
     */
    record Contact(double time, String obstacle, List<Vec> points) {
    }

    private static final double NEVER = Double.POSITIVE_INFINITY;

    private final ObstacleField field;
    private final RobotBody body;
    private final Candidates near = new Candidates();
    private Optional<Contact> contact = Optional.empty();

    Traffic(ObstacleField field, RobotBody body) {
        this.field = field;
        this.body = body;
    }

    /** The contact made since this was last asked. */
    Optional<Contact> takeContact() {
        Optional<Contact> taken = contact;
        contact = Optional.empty();
        return taken;
    }

    /** One tick. */
    void move(double dt) {
        Sweep rolling = body.sweep();
        double stop = contactWithStatic(rolling, dt);
        for (int which = 0; which < field.moving().size(); which++) {
            stop = Math.min(stop, contactWithMover(rolling, which, dt));
        }
        double end = Math.min(stop, dt);
        Pose before = body.pose();
        body.roll(end);
        for (int which = 0; which < field.moving().size(); which++) {
            advance(which, end);
        }
        if (stop < NEVER) {
            body.stop();
            contact = Optional.of(contactAt(stop, before));
            goOnAroundTheBody(dt - end);
        }
    }

    private void advance(int which, double time) {
        field.mover(which).advance(time);
        field.follow(which);
    }

    /** Lets every mover go on for the rest of a tick, or until it would run into the body at rest. */
    private void goOnAroundTheBody(double rest) {
        for (int which = 0; which < field.moving().size(); which++) {
            advance(which, Math.min(rest, contactWithMover(body.sweep(), which, rest)));
        }
    }

    private double contactWithStatic(Sweep rolling, double dt) {
        if (body.v() == 0 && body.omega() == 0) {
            return NEVER;
        }
        Pose pose = body.pose();
        near.clear();
        field.staticNear(pose.x(), pose.y(), body.span(dt) + Sweep.TOUCH, near);
        double stop = NEVER;
        for (int i = 0; i < near.size(); i++) {
            stop = Math.min(stop, rolling.firstContact(pose, near.figure(i), Vec.ZERO, Math.min(stop, dt)));
        }
        return stop;
    }

    /** When within a time the body, which sets out now, meets a moving obstacle, which does too. */
    private double contactWithMover(Sweep sweep, int which, double time) {
        for (Mover.Leg leg : field.mover(which).legs(time)) {
            Pose pose = sweep.after(body.pose(), leg.from());
            double contact = leg.from() + firstContact(sweep, pose, which, leg.start(), leg.velocity(), leg.to() - leg.from());
            if (contact < NEVER) {
                return contact;
            }
        }
        // A mover that stands is only met by a body that rolls.
        return contactWithStanding(sweep, which, time);
    }

    private double contactWithStanding(Sweep sweep, int which, double to) {
        List<Mover.Leg> legs = field.mover(which).legs(to);
        double arrived = legs.isEmpty() ? 0 : legs.get(legs.size() - 1).to();
        if (arrived >= to) {
            return NEVER;
        }
        Vec place = legs.isEmpty() ? field.mover(which).place() : endOf(legs.get(legs.size() - 1));
        return arrived + firstContact(sweep, sweep.after(body.pose(), arrived), which, place, Vec.ZERO, to - arrived);
    }

    private static Vec endOf(Mover.Leg leg) {
        return leg.start().plus(leg.velocity().times(leg.to() - leg.from()));
    }

    private double firstContact(Sweep sweep, Pose pose, int which, Vec place, Vec velocity, double time) {
        Outline outline = field.outline(field.moving().get(which));
        double dx = place.x() - outline.pose().x();
        double dy = place.y() - outline.pose().y();
        double stop = NEVER;
        for (Convex part : outline.parts()) {
            stop = Math.min(stop, sweep.firstContact(pose, part.shifted(dx, dy), velocity, Math.min(stop, time)));
        }
        return stop;
    }

    /** What the body touches now that it has rolled from a pose. */
    private Contact contactAt(double time, Pose before) {
        near.clear();
        field.allNear(before.x(), before.y(), body.spec().reach() + body.pose().position().distanceTo(before.position()) + 1e-6, near);
        String obstacle = "";
        List<Vec> points = new ArrayList<>();
        for (int i = 0; i < near.size(); i++) {
            List<Vec> found = body.contacts(near.figure(i));
            if (!found.isEmpty() && (obstacle.isEmpty() || obstacle.equals(field.idOf(near.owner(i))))) {
                obstacle = field.idOf(near.owner(i));
                points.addAll(found);
            }
        }
        return new Contact(time, obstacle, distinct(points));
    }

    private static List<Vec> distinct(List<Vec> points) {
        List<Vec> distinct = new ArrayList<>();
        for (Vec point : points) {
            if (distinct.stream().noneMatch(other -> other.distanceTo(point) < 1e-8)) {
                distinct.add(point);
            }
        }
        return distinct;
    }

    /**
     * Slides an obstacle straight from where it stands, turned already, to a place, until it touches the body at rest in this moment.
     *
     * @param owner the obstacle's place in the field
     * @param target where it would overlap the body
     * @return false where it would overlap the body even before it is slid
     */
    boolean slide(int owner, Pose target) {
        Vec from = field.obstacles().get(owner).pose().position();
        Pose turned = new Pose(from.x(), from.y(), target.heading());
        Outline outline = Outline.of(field.obstacles().get(owner).at(turned));
        if (!ObstacleField.isClear(body.box(), outline)) {
            return false;
        }
        Vec way = target.position().minus(from);
        Sweep still = new Sweep(body.spec().length(), body.spec().width(), 0, 0);
        double stop = 1;
        for (Convex part : outline.parts()) {
            stop = Math.min(stop, still.firstContact(body.pose(), part, way, stop));
        }
        Vec place = from.plus(way.times(stop));
        field.move(owner, new Pose(place.x(), place.y(), target.heading()));
        body.stop();
        contact = Optional.of(contactAt(0, body.pose()));
        return true;
    }
}
