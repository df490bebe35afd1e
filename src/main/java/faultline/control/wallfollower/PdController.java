package faultline.control.wallfollower;

import faultline.control.PdGains;

/**
 * The PD distance controller: omega = kp e + kd e', where e is the distance error, positive if the wall is too far; see
 * {@link PdGains}.
 */
final class PdController {

    private final PdGains gains;
    private final double speed;
    private double proportional;
    private double derivative;

    /** Creates a controller for a speed, metres per second. */
    PdController(double speed, PdGains gains) {
        this.speed = speed;
        this.gains = gains;
    }

    /**
     * {@return the turn rate that corrects an error, radians per second}
     *
     * @param error measured less wanted distance, metres
     * @param heading relative to the wall, radians, positive towards it
     */
    double turnRate(double error, double heading) {
        proportional = gains.proportionalTerm(error);
        derivative = gains.derivativeTerm(-speed * StrictMath.sin(heading));
        return proportional + derivative;
    }

    /** Returns the P term of the last call, radians per second. */
    double proportional() {
        return proportional;
    }

    /** Returns the D term of the last call, radians per second. */
    double derivative() {
        return derivative;
    }
}
