package faultline.control;

/**
 * The PD distance controller: omega = kp e + kd e', where e is how much too far the wall is. The gains follow from one length l, the way on which an error dies out:
 * with e'' = -v omega, kp = v / l^2 and kd = 2 / l make the loop critically damped at any speed.
 */
final class PdLaw {

    /** The shortest length, metres; shorter ones answer to the cone's edges. */
    private static final double SHORTEST = 0.06;

    /** The motors must be faster than the loop: the length is at least the way of this many time constants. */
    private static final double LAGS = 3;

    /** The steepest way back to the wanted distance, sine of the angle. */
    private static final double STEEPEST = 0.5;

    private final double length;
    private final double speed;
    private double proportional;
    private double derivative;

    /**
     * A law for a speed.
     *
     * @param speed metres per second
     * @param lag the motors' time constant and the control's delay, seconds
     */
    PdLaw(double speed, double lag) {
        this.speed = speed;
        this.length = Math.max(SHORTEST, LAGS * lag * speed);
    }

    /**
     * The turn rate that corrects an error.
     *
     * @param error measured less wanted distance, metres
     * @param heading relative to the wall, radians, positive towards it
     * @return omega, radians per second
     */
    double turnRate(double error, double heading) {
        double limit = 2 * length * STEEPEST;
        double rate = -speed * StrictMath.sin(heading);
        proportional = speed / (length * length) * Math.max(-limit, Math.min(limit, error));
        derivative = 2 / length * rate;
        return proportional + derivative;
    }

    /** The P term of the last call, radians per second. */
    double proportional() {
        return proportional;
    }

    /** The D term of the last call, radians per second. */
    double derivative() {
        return derivative;
    }
}
