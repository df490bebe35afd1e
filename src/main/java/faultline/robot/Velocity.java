package faultline.robot;

/**
 * The robot's velocity: [v, omega] in the paper's eq. (3).
 *
 * @param linear v, metres per second, positive ahead
 * @param angular omega, radians per second, positive to the left
 */
public record Velocity(double linear, double angular) {

    /** At rest. */
    public static final Velocity ZERO = new Velocity(0, 0);
}
