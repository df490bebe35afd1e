package faultline.control.diagnosis;

import faultline.sensor.Reading;

/** Tests whether the reading of one sensor stays exactly the same although the robot moves. */
final class StuckCheck {

    /**
     * A sensor is stuck if its reading stays exactly the same over a turn of this angle, radians, and unequal wheels
     * cannot explain the turn.
     */
    private static final double STUCK_TURN = StrictMath.toRadians(12);

    /**
     * The largest curvature that a robot with unequal wheels steers along a straight wall, radians per metre: wheels
     * that are larger and smaller by 5 percent, 0.17 m apart.
     */
    private static final double WHEEL_CURVATURE = 0.6;

    /** A sensor is also stuck if its reading stays exactly the same over this distance along its axis, metres. */
    private static final double STUCK_DISTANCE = 0.05;

    /**
     * The rule of {@link #STUCK_DISTANCE} does not apply if the sensor may see a wall along the path, whose nearest
     * point is at a border of the cone: that is, if the point there is farther than this from the path, metres.
     */
    private static final double BESIDE = 0.15;

    /**
     * A sensor is also stuck if its reading stays exactly the same while the turns of the steps change by this much in
     * total, radians. On a steady path along a wall a healthy reading may stay the same, but then the robot does not
     * steer.
     */
    private static final double STUCK_UNSTEADINESS = 1e-5;

    /** The minimum number of steps over which the last rule applies. */
    private static final int MIN_HELD_STEPS = 20;

    /** A sensor nearer to the robot's centre may read the same distance in a turn, metres. */
    private static final double MIN_LEVER = 0.01;

    /**
     * A sensor that reads less than this touches a surface, metres: the reading cannot stay the same while the robot
     * drives {@link #STUCK_DISTANCE} in any direction, or turns by as many radians.
     */
    private static final double TOUCHING = 0.001;

    private final MountedCone cone;
    private final MotionAccumulator motion;
    private final double axisCos;
    private final double leftBorderSin;
    private final double rightBorderSin;
    private final boolean hasLever;

    /** The motion of the robot while the reading stays the same: its turn, radians, and distance, metres. */
    private double turn;

    private double distance;
    /** The total unsteadiness of the robot while the reading stays the same, radians, and the number of steps. */
    private double held;

    private int heldSteps;
    /** The greatest total after which the reading changed. */
    private double longestHeld;

    StuckCheck(MountedCone cone, MotionAccumulator motion) {
        this.cone = cone;
        this.motion = motion;
        this.hasLever = StrictMath.hypot(cone.x(), cone.y()) > MIN_LEVER;
        this.axisCos = StrictMath.cos(cone.bearing());
        this.leftBorderSin = StrictMath.sin(cone.bearing() + cone.half());
        this.rightBorderSin = StrictMath.sin(cone.bearing() - cone.half());
    }

    /** Returns whether a reading after some motion, and the one before it, are those of a stuck sensor. */
    boolean test(double reading, double before) {
        if (reading != before || reading == Reading.NOTHING) {
            release();
            return false;
        }
        turn += motion.turned();
        distance += motion.rolled();
        held += motion.unsteadiness();
        heldSteps++;
        return Math.abs(turn) > STUCK_TURN + WHEEL_CURVATURE * Math.abs(distance)
                || Math.abs(distance * axisCos) > STUCK_DISTANCE && cone.looksAhead() && !mayBeBeside(reading)
                || isHeld()
                || reading < TOUCHING && Math.abs(distance) + Math.abs(turn) > STUCK_DISTANCE;
    }

    /** Returns whether the last reading was the same as the one before it. */
    boolean isHolding() {
        return heldSteps > 0;
    }

    /** Records that the reading has changed. */
    private void release() {
        if (heldSteps > 0) {
            turn = 0;
            distance = 0;
            longestHeld = Math.max(longestHeld, held);
            held = 0;
            heldSteps = 0;
        }
    }

    /**
     * Returns whether the robot steers but the reading stays the same. The reading of a sensor that resolves only
     * coarse steps also stays the same, so it must stay for twice as long as it ever did before.
     */
    private boolean isHeld() {
        return heldSteps >= MIN_HELD_STEPS && held > Math.max(STUCK_UNSTEADINESS, 2 * longestHeld) && hasLever;
    }

    /** Returns whether a point at a border of the cone, at the distance of a reading, is beside the path. */
    private boolean mayBeBeside(double reading) {
        return cone.y() + reading * leftBorderSin > BESIDE || cone.y() + reading * rightBorderSin < -BESIDE;
    }
}
