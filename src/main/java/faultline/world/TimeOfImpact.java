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
 * The first contact of the robot's body, which moves along an exact arc, with a figure that moves straight:
 * conservative advancement (B. Mirtich 1996), which no speed and no thin wall can outrun.
 *
 * <p>At each moment the line through the figure's nearest point, square to the gap, keeps the figure on one side. The
 * body is let go on only for as long as none of its corners can have crossed that line: a corner with velocity w and
 * the body's turn rate omega comes nearer by no more than (w . n - u . n) s + |w| |omega| s^2 / 2 in a time s, where u
 * is the figure's velocity. The steps shrink as Newton's do.
 */
final class TimeOfImpact {

    /**
     * The gap at which things count as touching, metres: far above rounding, far below the 1e-9 that the world
     * promises.
     */
    static final double TOUCH_DISTANCE = 1e-10;

    private static final int MAX_STEPS = 10_000;

    /** How many roundings, at most, lie between the true ends of a gap and those computed. */
    private static final int MAX_ROUNDINGS = 8;

    private final double length;
    private final double width;
    private final Velocity velocity;

    /**
     * Sweeps of a body at constant velocities.
     *
     * @param length of the body, metres
     * @param width of the body, metres
     * @param velocity of the body
     */
    TimeOfImpact(double length, double width, Velocity velocity) {
        this.length = length;
        this.width = width;
        this.velocity = velocity;
    }

    /**
     * When the body first touches a figure and still goes nearer.
     *
     * @param start the body's pose at time 0
     * @param figure the figure at time 0, clear of the body or touching it
     * @param shapeVelocity the figure's, metres per second
     * @param time how long both move, seconds
     * @return seconds in [0, time], or positive infinity where they do not meet
     */
    double firstContactTime(Pose start, ConvexShape figure, Vector2 shapeVelocity, double time) {
        double now = 0;
        for (int step = 0; step < MAX_STEPS; step++) {
            Pose pose = poseAfter(start, now);
            OrientedBox box = new OrientedBox(pose, length, width);
            ConvexShape there = now == 0 ? figure : figure.translated(shapeVelocity.x() * now, shapeVelocity.y() * now);
            Separation gap = BoxDistance.between(box, there);
            if (gap.distance() == 0) {
                return now;
            }
            Vector2 normal = gap.onShape().minus(gap.onBox()).times(1 / gap.distance());
            if (gap.distance() <= TOUCH_DISTANCE && closingSpeed(pose, gap.onBox(), normal, shapeVelocity) > 0) {
                return now;
            }
            now += safeTime(pose, box, gap, normal, shapeVelocity);
            if (now >= time) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return now;
    }

    /** The body's pose after a time from another. */
    Pose poseAfter(Pose start, double time) {
        return time == 0 ? start : DifferentialDrive.advance(start, velocity, time);
    }

    /** The velocity at which a point of the body and the figure come together along the normal. */
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
     * How long no corner of the body can reach the line through the figure's nearest point; half the touching gap is
     * left over. The direction of a short gap is known only to the rounding of its two ends, which tilts the line: a
     * corner far along it gets that much less room, but never less than the gap.
     */
    private double safeTime(Pose pose, OrientedBox box, Separation gap, Vector2 normal, Vector2 shapeVelocity) {
        double least = Double.POSITIVE_INFINITY;
        double tilt = MAX_ROUNDINGS
                * Math.ulp(Math.abs(box.frame().x()) + Math.abs(box.frame().y()) + box.boundingRadius())
                / gap.distance();
        for (int i = 0; i < 4; i++) {
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

    /** The s > 0 at which rate s + bend s^2 / 2 = slack, positive infinity where there is none. */
    private static double crossingTime(double slack, double rate, double bend) {
        double root = rate + Math.sqrt(rate * rate + 2 * bend * slack);
        return root > 0 ? 2 * slack / root : Double.POSITIVE_INFINITY;
    }
}
