package faultline.control.fallback;

import faultline.control.diagnosis.MountedCone;
import faultline.control.diagnosis.SensorDiagnosis;

/**
 * The direction in which the robot drives. If all trusted sensors look back, they see more of the path when the robot
 * drives backwards, and it does not have to turn around to see it.
 */
enum DriveDirection {
    FORWARDS(0, 1),
    BACKWARDS(StrictMath.PI, -1);

    private static final double QUARTER = StrictMath.PI / 2;

    /** The maximum bearing of a sensor that looks ahead, on either side, radians. */
    private static final double AHEAD = StrictMath.toRadians(60);

    /** The maximum angle by which a sensor that faces the wall looks back from the perpendicular, radians. */
    private static final double BESIDE = StrictMath.toRadians(20);

    private final double turn;
    private final double sign;

    DriveDirection(double turn, double sign) {
        this.turn = turn;
        this.sign = sign;
    }

    /** Returns the direction for the trusted sensors: backwards if none of them looks ahead or faces the wall. */
    static DriveDirection of(SensorDiagnosis diagnosis) {
        for (int i = 0; i < diagnosis.sensors(); i++) {
            if (diagnosis.isTrusted(i) && looksAheadOrAtWall(diagnosis.cone(i))) {
                return FORWARDS;
            }
        }
        return BACKWARDS;
    }

    private static boolean looksAheadOrAtWall(MountedCone cone) {
        return cone.bearing() >= -AHEAD && cone.bearing() <= QUARTER + BESIDE;
    }

    /** Returns the direction of motion for a heading, radians. */
    double leading(double heading) {
        return heading + turn;
    }

    /** Returns the linear velocity of a speed. */
    double velocity(double speed) {
        return sign * speed;
    }
}
