package faultline.robot;

import faultline.geometry.Pose;
import faultline.geometry.StrictTrig;

/** The kinematics of the differential drive: the paper's eqs. (2) and (3), integrated exactly along the arc. */
public final class DifferentialDrive {

    /** Below this angle, radians, sin x / x = 1 - x^2 / 6 to the last bit; the quotient is not defined at 0. */
    private static final double SMALL_ANGLE = 1e-4;

    private DifferentialDrive() {}

    /**
     * Returns the pose after a time at constant velocity: the integral of eq. (3), q' = J(q) [v, omega], along the arc.
     * The chord of the arc has length v dt sin(h) / h and direction theta + h, where h = omega dt / 2.
     *
     * @param from q = [x, y, theta]
     * @param velocity [v, omega]
     * @param dt the time, seconds
     * @return the new pose; its heading is not normalised
     */
    public static Pose advance(Pose from, Velocity velocity, double dt) {
        double turn = velocity.angular() * dt;
        double half = turn / 2;
        double chord = velocity.linear() * dt * chordPerArc(half);
        double direction = from.heading() + half;
        return new Pose(
                from.x() + chord * StrictTrig.cos(direction),
                from.y() + chord * StrictTrig.sin(direction),
                from.heading() + turn);
    }

    /**
     * {@return the length of the chord of an arc divided by that of the arc: sin(half) / half}
     *
     * @param half half the turn along the arc, radians
     */
    public static double chordPerArc(double half) {
        return Math.abs(half) < SMALL_ANGLE ? 1 - half * half / 6 : StrictTrig.sin(half) / half;
    }
}
