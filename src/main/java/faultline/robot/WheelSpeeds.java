package faultline.robot;

/**
 * The speeds of the two sides' wheels at the rim.
 *
 * @param left the speed of the left wheels, metres per second, positive ahead
 * @param right the speed of the right wheels, metres per second, positive ahead
 */
public record WheelSpeeds(double left, double right) {

    /**
     * Creates wheel speeds.
     *
     * @param left the speed of the left wheels, metres per second, positive ahead
     * @param right the speed of the right wheels, metres per second, positive ahead
     * @throws IllegalArgumentException if a speed is not finite
     */
    public WheelSpeeds {
        if (!(Double.isFinite(left) && Double.isFinite(right))) {
            throw new IllegalArgumentException("wheel speeds must be finite: " + left + ", " + right);
        }
    }

    /**
     * {@return the wheel speeds for a velocity of the robot: the inverse of {@link #toVelocity}}
     *
     * @param velocity the velocity of the robot
     * @param track the distance between the left and the right wheels, metres
     */
    public static WheelSpeeds of(Velocity velocity, double track) {
        double half = velocity.angular() * track / 2;
        return new WheelSpeeds(velocity.linear() - half, velocity.linear() + half);
    }

    /**
     * {@return the robot's velocity: v = (v_r + v_l) / 2 and omega = (v_r - v_l) / track}
     *
     * @param track the distance between the left and the right wheels, metres
     */
    public Velocity toVelocity(double track) {
        return new Velocity(linear(), (right - left) / track);
    }

    /** {@return the robot's linear velocity, metres per second, positive ahead} */
    public double linear() {
        return (right + left) / 2;
    }
}
