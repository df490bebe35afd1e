package faultline.control.fallback;

import faultline.control.diagnosis.MountedCone;
import faultline.control.diagnosis.SensorDiagnosis;

/**
 * Which end of the robot goes first. A robot whose trusted sensors all look back sees more of its way if it drives
 * backwards: it need not turn around to look ahead.
 */
enum Gear {
    FORWARDS(0, 1),
    BACKWARDS(StrictMath.PI, -1);

    private static final double QUARTER = StrictMath.PI / 2;

    /** Sensors look ahead up to this bearing on either side, radians. */
    private static final double AHEAD = StrictMath.toRadians(60);

    /** One that faces the wall looks no farther back than this from square to it, radians. */
    private static final double BESIDE = StrictMath.toRadians(20);

    private final double turn;
    private final double sign;

    Gear(double turn, double sign) {
        this.turn = turn;
        this.sign = sign;
    }

    /** Returns the gear for the trusted sensors: backwards if none of them looks ahead or faces the wall. */
    static Gear of(SensorDiagnosis diagnosis) {
        for (int i = 0; i < diagnosis.sensors(); i++) {
            if (diagnosis.isTrusted(i) && looksAhead(diagnosis.cone(i))) {
                return FORWARDS;
            }
        }
        return BACKWARDS;
    }

    private static boolean looksAhead(MountedCone cone) {
        return cone.bearing() >= -AHEAD && cone.bearing() <= QUARTER + BESIDE;
    }

    /** Returns the direction of the end that goes first, for a heading, radians. */
    double leading(double heading) {
        return heading + turn;
    }

    /** Returns the linear velocity of a speed. */
    double velocity(double speed) {
        return sign * speed;
    }
}
