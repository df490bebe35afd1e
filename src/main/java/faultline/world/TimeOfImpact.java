package faultline.world;

import faultline.geometry.BoxDistance;
import faultline.geometry.ConvexShape;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Separation;
import faultline.geometry.Vector2;
import faultline.robot.DifferentialDrive;
import faultline.robot.Velocity;

/**
 * The first contact of the robot's body, which moves along an exact arc, with a shape that moves straight: conservative
 * advancement (B. Mirtich 1996), in which no speed is too high and no wall too thin.
 *
 * <p>At each step, the line through the shape's nearest point, perpendicular to the gap, keeps the shape on one side.
 * The body advances only for as long as none of its corners can have crossed that line: a corner with velocity w and
 * the body's turn rate omega approaches by at most (w . n - u . n) s + |w| |omega| s^2 / 2 in a time s, where u is the
 * shape's velocity. The steps shrink as Newton's do.
 */
final class TimeOfImpact {

    /**
     * The gap that counts as contact, metres: far below the tolerance of 1e-9, and far above the rounding errors of
     * coordinates up to 1 km. From 10 km on, the errors are a share of this, and the body may stop late, in the shape:
     * beside a wall 90 km away by up to a micrometre.
     */
    static final double TOUCH_DISTANCE = 1e-10;

    /**
     * A gap whose direction rounding may tilt, metres. A shape that the body approaches at a very small angle may seem
     * to recede across such a gap, so that no step ends at it. At a gap of 1e-10 m, this happens at angles of 1e-5
     * radians at the origin and of 1e-3 radians at 500 m.
     */
    private static final double SHORT_GAP = 1e-6;

    private static final int MAX_STEPS = 100_000;

    /** A body that turns further than this in one test, radians, is also advanced by its bounding circle. */
    private static final double FAST_TURN = StrictMath.PI;

    /** The maximum number of roundings between the true ends of a gap and those computed. */
    private static final int MAX_ROUNDINGS = 8;

    private final double length;
    private final double width;
    private final Velocity velocity;

    /**
     * Creates a test of a body at constant velocity.
     *
     * @param length the length of the body, metres
     * @param width the width of the body, metres
     * @param velocity the velocity of the body
     */
    TimeOfImpact(double length, double width, Velocity velocity) {
        this.length = length;
        this.width = width;
        this.velocity = velocity;
    }

    /**
     * Returns when the body first touches a shape while approaching it.
     *
     * @param start the body's pose at time 0
     * @param shape the shape at time 0, clear of the body or touching it
     * @param shapeVelocity the velocity of the shape, metres per second
     * @param time the duration of the motion, seconds
     * @return seconds in [0, time], or positive infinity if they do not meet
     * @throws World.UnresolvedContactException if the steps are too many
     */
    double firstContactTime(Pose start, ConvexShape shape, Vector2 shapeVelocity, double time) {
        double end = Math.min(time, period(shapeVelocity));
        boolean fast = Math.abs(velocity.angular()) * end > FAST_TURN;
        double clear = 0;
        double now = 0;
        for (int step = 0; step < MAX_STEPS; step++) {
            Pose pose = poseAfter(start, now);
            OrientedBox box = new OrientedBox(pose, length, width);
            ConvexShape moved = shapeAfter(shape, shapeVelocity, now);
            Separation gap = BoxDistance.between(box, moved);
            if (gap.distance() == 0) {
                return contactTimeBetween(clear, now, start, shape, shapeVelocity);
            }
            clear = now;
            Vector2 normal = gap.onShape().minus(gap.onBox()).times(1 / gap.distance());
            if (gap.distance() <= TOUCH_DISTANCE && closingSpeed(pose, gap.onBox(), normal, shapeVelocity) > 0) {
                return now;
            }
            double safe = safeTime(pose, box, gap, normal, shapeVelocity);
            now += fast ? Math.max(safe, safeTimeOfCircle(box, moved, shapeVelocity)) : safe;
            if (now >= end) {
                return gap.distance() <= SHORT_GAP && isOverlapping(start, shape, shapeVelocity, end)
                        ? contactTimeBetween(clear, end, start, shape, shapeVelocity)
                        : Double.POSITIVE_INFINITY;
            }
        }
        throw new World.UnresolvedContactException("the contacts of the robot cannot be found in " + MAX_STEPS
                + " steps; it turns by " + Math.abs(velocity.angular()) * time + " radians in one tick");
    }

    /**
     * Returns when a shape that slides straight first touches the body, which is at rest. Unlike
     * {@link #firstContactTime}, this also finds a shape that slides along the body at a short gap and comes nearer by
     * less than the rounding of the direction of the gap.
     *
     * @param pose the body's pose
     * @param shape the shape at time 0, clear of the body or touching it
     * @param shapeVelocity the velocity of the shape, metres per second
     * @param time the duration of the motion, seconds
     * @return seconds in [0, time], or positive infinity if they do not meet
     */
    double slideContactTime(Pose pose, ConvexShape shape, Vector2 shapeVelocity, double time) {
        double contact;
        try {
            contact = firstContactTime(pose, shape, shapeVelocity, time);
        } catch (World.UnresolvedContactException tooManySteps) {
            contact = Double.POSITIVE_INFINITY;
        }
        return contact <= time ? contact : hiddenContactTime(pose, shape, shapeVelocity, time);
    }

    /** The distance of two convex shapes is a convex function of the time: a search finds where they overlap. */
    private double hiddenContactTime(Pose pose, ConvexShape shape, Vector2 shapeVelocity, double time) {
        OrientedBox box = new OrientedBox(pose, length, width);
        double reach = box.boundingRadius() + shapeVelocity.length() * time;
        double low = 0;
        double high = shape.distanceTo(pose.x(), pose.y()) > reach ? 0 : time;
        while (high - low > Math.ulp(time)) {
            double third = (high - low) / 3;
            double gap = BoxDistance.between(box, shapeAfter(shape, shapeVelocity, low + third))
                    .distance();
            double laterGap = BoxDistance.between(box, shapeAfter(shape, shapeVelocity, high - third))
                    .distance();
            if (gap == 0 || laterGap == 0) {
                double overlapping = gap == 0 ? low + third : high - third;
                return contactTimeBetween(0, overlapping, pose, shape, shapeVelocity);
            }
            low = gap > laterGap ? low + third : low;
            high = gap > laterGap ? high : high - third;
        }
        return Double.POSITIVE_INFINITY;
    }

    private static ConvexShape shapeAfter(ConvexShape shape, Vector2 velocity, double time) {
        return time == 0 ? shape : shape.translated(velocity.x() * time, velocity.y() * time);
    }

    private boolean isOverlapping(Pose start, ConvexShape shape, Vector2 shapeVelocity, double time) {
        OrientedBox box = new OrientedBox(poseAfter(start, time), length, width);
        return BoxDistance.between(box, shapeAfter(shape, shapeVelocity, time)).distance() == 0;
    }

    /**
     * Returns when the body touches a shape between a time at which it is clear of it and one at which they overlap.
     * The nearest point of a long shape is known only to the rounding of its own coordinates. That can tilt the line
     * across a short gap so far that a corner far along it moves into the shape.
     */
    private double contactTimeBetween(
            double clear, double overlapping, Pose start, ConvexShape shape, Vector2 shapeVelocity) {
        double from = clear;
        double to = overlapping;
        double middle = from + (to - from) / 2;
        while (middle > from && middle < to) {
            OrientedBox box = new OrientedBox(poseAfter(start, middle), length, width);
            double gap = BoxDistance.between(box, shapeAfter(shape, shapeVelocity, middle))
                    .distance();
            if (gap > 0 && gap <= TOUCH_DISTANCE) {
                return middle;
            }
            from = gap > 0 ? middle : from;
            to = gap > 0 ? to : middle;
            middle = from + (to - from) / 2;
        }
        return from;
    }

    /**
     * Returns the time after which the motion repeats itself: that of a whole turn on the spot beside a static shape.
     */
    private double period(Vector2 shapeVelocity) {
        boolean repeats = velocity.linear() == 0 && shapeVelocity.equals(Vector2.ZERO) && velocity.angular() != 0;
        return repeats ? 2.01 * StrictMath.PI / Math.abs(velocity.angular()) : Double.POSITIVE_INFINITY;
    }

    /** Returns how long the circle about the body cannot reach a shape, however the body turns; at least 0. */
    private double safeTimeOfCircle(OrientedBox box, ConvexShape shape, Vector2 shapeVelocity) {
        double room = shape.distanceTo(box.frame().x(), box.frame().y()) - box.boundingRadius() - TOUCH_DISTANCE;
        return room <= 0 ? 0 : room / (Math.abs(velocity.linear()) + shapeVelocity.length());
    }

    /** Returns the body's pose after some seconds. */
    Pose poseAfter(Pose start, double time) {
        return time == 0 ? start : DifferentialDrive.advance(start, velocity, time);
    }

    /** Returns the speed at which a point of the body and the shape approach along the normal. */
    private double closingSpeed(Pose pose, Vector2 point, Vector2 normal, Vector2 shapeVelocity) {
        return velocityAt(pose, point).minus(shapeVelocity).dot(normal);
    }

    private Vector2 velocityAt(Pose pose, Vector2 point) {
        Vector2 arm = point.minus(pose.position());
        return Vector2.direction(pose.heading())
                .times(velocity.linear())
                .plus(arm.perpendicular().times(velocity.angular()));
    }

    /**
     * Returns how long no corner of the body can reach the line through the shape's nearest point, less half the touch
     * distance. The direction of a short gap is known only to the rounding of its two ends, which tilts the line: a
     * corner far along it gets that much less room, but never less than the gap.
     */
    private double safeTime(Pose pose, OrientedBox box, Separation gap, Vector2 normal, Vector2 shapeVelocity) {
        double least = Double.POSITIVE_INFINITY;
        double tilt = MAX_ROUNDINGS
                * Math.ulp(Math.abs(box.frame().x()) + Math.abs(box.frame().y()) + box.boundingRadius())
                / gap.distance();
        for (int i = 0; i < OrientedBox.CORNERS; i++) {
            Vector2 corner = box.corner(i);
            Vector2 room = gap.onShape().minus(corner);
            double slack = Math.max(room.dot(normal) - tilt * room.length(), gap.distance()) - TOUCH_DISTANCE / 2;
            Vector2 w = velocityAt(pose, corner);
            double rate = w.minus(shapeVelocity).dot(normal);
            double bend = w.length() * Math.abs(velocity.angular());
            least = Math.min(least, crossingTime(Math.max(slack, TOUCH_DISTANCE / 8), rate, bend));
        }
        return least;
    }

    /** Returns the s &gt; 0 at which rate s + bend s^2 / 2 = slack, positive infinity if there is none. */
    private static double crossingTime(double slack, double rate, double bend) {
        double root = rate + Math.sqrt(rate * rate + 2 * bend * slack);
        return root > 0 ? 2 * slack / root : Double.POSITIVE_INFINITY;
    }
}
