package faultline.robot;

import faultline.geometry.Pose;

/** The kinematics of the differential drive: the paper's eqs. (2) and (3), integrated exactly along the arc. */
public final class DifferentialDrive {

    /**
     * Below this turn in a tick the closed form loses digits to its series: sin x / x = 1 - x^2/6 is exact to the last
     * bit there.
     */
    private static final double SMALL_ANGLE = 1e-4;

    private DifferentialDrive() {}

    /**
     * The linear velocity from the wheel speeds.
     *
     * @param left metres per second
     * @param right metres per second
     * @return v = (v_r + v_l) / 2, metres per second, positive ahead
     */
    public static double linearVelocity(double left, double right) {
        return (right + left) / 2;
    }

    /**
     * The angular velocity from the wheel speeds.
     *
     * @param left metres per second
     * @param right metres per second
     * @param track width, metres
     * @return omega = (v_r - v_l) / track, radians per second, positive to the left
     */
    public static double angularVelocity(double left, double right, double track) {
        return (right - left) / track;
    }

    /**
     * The pose after a time at constant velocities: the integral of eq. (3), q' = J(q) [v, omega], along the arc.
     *
     * <p>The chord of the arc has length v dt sin(h)/h and direction theta + h, where h = omega dt / 2.
     *
     * @param from q = [x, y, theta]
     * @param v metres per second
     * @param omega radians per second
     * @param dt seconds
     * @return the new pose; its heading is not normalised
     */
    public static Pose advance(Pose from, double v, double omega, double dt) {
        double turn = omega * dt;
        double half = turn / 2;
        double chord = v * dt * sinc(half);
        double direction = from.heading() + half;
        return new Pose(
                from.x() + chord * StrictMath.cos(direction),
                from.y() + chord * StrictMath.sin(direction),
                from.heading() + turn);
    }

    /** sin(x) / x, with its Taylor limit. */
    private static double sinc(double x) {
        return Math.abs(x) < SMALL_ANGLE ? 1 - x * x / 6 : StrictMath.sin(x) / x;
    }
}
