package faultline.world;

import faultline.geometry.Box;
import faultline.geometry.BoxGap;
import faultline.geometry.Convex;
import faultline.geometry.Gap;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.DifferentialDrive;

/**
 * The first contact of the robot's body, which moves along an exact arc, with a figure that moves straight: conservative advancement (B.
 * Mirtich 1996), which no speed and no thin wall can outrun.
 *
 * <p>At each moment the line through the figure's nearest point, square to the gap, keeps the figure on one side. The body is let go on
 * only for as long as none of its corners can have crossed that line: a corner with velocity w and the body's turn rate omega comes nearer
 * by no more than (w . n - u . n) s + |w| |omega| s^2 / 2 in a time s, where u is the figure's velocity. The steps shrink as Newton's do.
 */
final class Sweep {

    /** The gap at which things count as touching, metres: far above rounding, far below the 1e-9 that the world promises. */
    static final double TOUCH = 1e-10;

    private static final int MOST_STEPS = 10_000;

    /** How many roundings, at most, lie between the true ends of a gap and those computed. */
    private static final int ROUNDINGS = 8;

    private final double length;
    private final double width;
    private final double v;
    private final double omega;

    /**
     * Sweeps of a body at constant velocities.
     *
     * @param length of the body, metres
     * @param width of the body, metres
     * @param v linear velocity, metres per second
     * @param omega angular velocity, radians per second
     */
    Sweep(double length, double width, double v, double omega) {
        this.length = length;
        this.width = width;
        this.v = v;
        this.omega = omega;
    }

    /**
     * When the body first touches a figure and still goes nearer.
     *
     * @param start the body's pose at time 0
     * @param figure the figure at time 0, clear of the body or touching it
     * @param velocity the figure's, metres per second
     * @param time how long both move, seconds
     * @return seconds in [0, time], or positive infinity where they do not meet
     */
    double firstContact(Pose start, Convex figure, Vec velocity, double time) {
        double now = 0;
        for (int step = 0; step < MOST_STEPS; step++) {
            Pose pose = after(start, now);
            Box box = new Box(pose, length, width);
            Convex there = now == 0 ? figure : figure.shifted(velocity.x() * now, velocity.y() * now);
            Gap gap = BoxGap.between(box, there);
            if (gap.distance() == 0) {
                return now;
            }
            Vec normal = gap.onFigure().minus(gap.onBox()).times(1 / gap.distance());
            if (gap.distance() <= TOUCH && approach(pose, gap.onBox(), normal, velocity) > 0) {
                return now;
            }
            now += safeTime(pose, box, gap, normal, velocity);
            if (now >= time) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return now;
    }

    /** The body's pose after a time from another. */
    Pose after(Pose start, double time) {
        return time == 0 ? start : DifferentialDrive.advance(start, v, omega, time);
    }

    /** The velocity at which a point of the body and the figure come together along the normal. */
    private double approach(Pose pose, Vec point, Vec normal, Vec velocity) {
        return velocityOf(pose, point).minus(velocity).dot(normal);
    }

    private Vec velocityOf(Pose pose, Vec point) {
        Vec arm = point.minus(pose.position());
        return Vec.direction(pose.heading()).times(v).plus(arm.perpendicular().times(omega));
    }

    /**
     * How long no corner of the body can reach the line through the figure's nearest point; half the touching gap is left over. The
     * direction of a short gap is known only to the rounding of its two ends, which tilts the line: a corner far along it gets that much
     * less room, but never less than the gap.
     */
    private double safeTime(Pose pose, Box box, Gap gap, Vec normal, Vec velocity) {
        double least = Double.POSITIVE_INFINITY;
        double tilt = ROUNDINGS * Math.ulp(Math.abs(box.cx()) + Math.abs(box.cy()) + box.reach()) / gap.distance();
        for (int i = 0; i < 4; i++) {
            Vec corner = box.corner(i);
            Vec room = gap.onFigure().minus(corner);
            double slack = Math.max(room.dot(normal) - tilt * room.length(), gap.distance()) - TOUCH / 2;
            Vec w = velocityOf(pose, corner);
            double rate = w.minus(velocity).dot(normal);
            double bend = w.length() * Math.abs(omega);
            least = Math.min(least, reachTime(Math.max(slack, TOUCH / 8), rate, bend));
        }
        return least;
    }

    /** The s > 0 at which rate s + bend s^2 / 2 = slack, positive infinity where there is none. */
    private static double reachTime(double slack, double rate, double bend) {
        double root = rate + Math.sqrt(rate * rate + 2 * bend * slack);
        return root > 0 ? 2 * slack / root : Double.POSITIVE_INFINITY;
    }
}
