package faultline.control.diagnosis;

import faultline.control.Odometer;
import faultline.robot.RobotSpec;

/**
 * The robot's pose by dead reckoning, from the controller's voltages and the model of the motors. The frame has its
 * origin at the start of the run and the wall on the left.
 */
public final class DeadReckoning {

    /** Below this angle the series of sine and cosine to the fifth power are exact, radians. */
    private static final double SMALL_TURN = 0.02;

    /** The inverse factorials of the series; products take less time than quotients. */
    private static final double HALF = 1 / 2.0;

    private static final double SIXTH = 1 / 6.0;
    private static final double TWENTY_FOURTH = 1 / 24.0;
    private static final double HUNDRED_TWENTIETH = 1 / 120.0;

    private final Odometer odometer = new Odometer();
    private double x;
    private double y;
    private double heading;
    private double headingCos = 1;
    private double headingSin;
    private double rolled;
    private double turned;
    private double distance;
    private double turning;
    private double curvature;

    DeadReckoning() {}

    /**
     * Updates the pose after voltages have acted for some ticks.
     *
     * @param robot the robot as the controller believes it to be
     * @param leftVolts the voltage on the side next to the wall
     * @param rightVolts the voltage on the other side
     * @param dt the length of a tick, seconds
     * @param ticks the number of ticks
     */
    void advance(RobotSpec robot, double leftVolts, double rightVolts, double dt, long ticks) {
        rolled = 0;
        turned = 0;
        odometer.begin(robot, dt);
        for (long i = 0; i < ticks; i++) {
            odometer.step(leftVolts, rightVolts);
            double step = odometer.stepDistance();
            double turn = odometer.stepTurn() + curvature * step;
            // The direction at the middle of the arc, to second order in the turn of a tick.
            double half = turn / 2;
            double shrink = 1 - half * half / 2;
            x += step * (headingCos * shrink - headingSin * half);
            y += step * (headingSin * shrink + headingCos * half);
            turn(turn);
            rolled += step;
            turned += turn;
            distance += Math.abs(step);
            turning += Math.abs(turn);
        }
    }

    /** Sets the curvature to the left that the motor model lacks, 1/m. */
    void setCurvature(double perMetre) {
        curvature = perMetre;
    }

    /** Turns the heading; by a small angle without trigonometric functions, up to rounding. */
    private void turn(double angle) {
        heading += angle;
        if (angle == 0) {
            return;
        }
        if (Math.abs(angle) > SMALL_TURN) {
            headingCos = StrictMath.cos(heading);
            headingSin = StrictMath.sin(heading);
            return;
        }
        double square = angle * angle;
        double cos = 1 - square * (HALF - square * TWENTY_FOURTH);
        double sin = angle * (1 - square * (SIXTH - square * HUNDRED_TWENTIETH));
        double turnedCos = headingCos * cos - headingSin * sin;
        double turnedSin = headingSin * cos + headingCos * sin;
        // One step of Newton's method keeps the length at 1.
        double scale = (3 - turnedCos * turnedCos - turnedSin * turnedSin) / 2;
        headingCos = turnedCos * scale;
        headingSin = turnedSin * scale;
    }

    /**
     * Returns the position ahead of the start.
     *
     * @return metres
     */
    public double x() {
        return x;
    }

    /**
     * Returns the position to the left of the start.
     *
     * @return metres
     */
    public double y() {
        return y;
    }

    /**
     * Returns the total turn.
     *
     * @return radians, positive to the left, not normalised
     */
    public double heading() {
        return heading;
    }

    /** Returns the cosine of the heading. */
    double headingCos() {
        return headingCos;
    }

    /** Returns the sine of the heading. */
    double headingSin() {
        return headingSin;
    }

    /**
     * Returns the distance rolled in the last step.
     *
     * @return metres, negative backwards
     */
    public double rolled() {
        return rolled;
    }

    /**
     * Returns the turn of the last step.
     *
     * @return radians, positive to the left
     */
    public double turned() {
        return turned;
    }

    /** {@return the total distance rolled, forwards and backwards, metres} */
    public double distance() {
        return distance;
    }

    /** Returns the total angle turned in both directions, radians. */
    double turning() {
        return turning;
    }

    /**
     * Returns the odometer, which knows nothing of the curvature that the motor model lacks.
     *
     * @return the live odometer, which {@link #advance} updates
     */
    public Odometer odometer() {
        return odometer;
    }
}
