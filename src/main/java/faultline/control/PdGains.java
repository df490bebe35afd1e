package faultline.control;

/**
 * The gains of the PD distance controller. They follow from one length l, the distance over which an error decays: with
 * e'' = -v omega, kp = v / l^2 and kd = 2 / l make the loop critically damped at any speed.
 *
 * @param proportional kp, radians per second for each metre that the wall is too far
 * @param derivative kd, radians per second for each metre per second that it recedes
 * @param maxError the error at which the P term is limited, metres
 */
public record PdGains(double proportional, double derivative, double maxError) {

    /** The shortest length, metres; shorter ones react to the cone's edges. */
    private static final double MIN_LENGTH = 0.06;

    /**
     * The motors must be faster than the control loop: the length is at least the distance driven in this many time
     * constants.
     */
    private static final double MIN_LAGS = 3;

    /** The sine of the largest angle at which the robot returns to the wanted distance. */
    private static final double MAX_APPROACH_SINE = 0.5;

    /**
     * {@return the gains that the follower uses}
     *
     * @param speed metres per second
     * @param lag the motors' time constant and the control's delay, seconds
     */
    public static PdGains forSpeed(double speed, double lag) {
        return criticallyDamped(Math.max(MIN_LENGTH, MIN_LAGS * lag * speed), speed);
    }

    /**
     * {@return the critically damped gains of a length}
     *
     * @param length the length over which an error decays, metres, positive
     * @param speed metres per second, positive
     */
    public static PdGains criticallyDamped(double length, double speed) {
        return new PdGains(speed / (length * length), 2 / length, 2 * length * MAX_APPROACH_SINE);
    }

    /**
     * {@return any gains, with the same limit of the P term}
     *
     * @param proportional kp, radians per second for each metre, positive
     * @param derivative kd, radians per second for each metre per second, positive
     * @param speed metres per second, positive
     */
    public static PdGains withErrorLimit(double proportional, double derivative, double speed) {
        return new PdGains(proportional, derivative, MAX_APPROACH_SINE * derivative * speed / proportional);
    }

    /**
     * {@return the P term, radians per second, positive towards the wall}
     *
     * @param error measured less wanted distance, metres
     */
    public double proportionalTerm(double error) {
        return proportional * Math.max(-maxError, Math.min(maxError, error));
    }

    /**
     * {@return the D term, radians per second, positive towards the wall}
     *
     * @param rate the rate of the error, metres per second, positive if the wall recedes
     */
    public double derivativeTerm(double rate) {
        return derivative * rate;
    }
}
