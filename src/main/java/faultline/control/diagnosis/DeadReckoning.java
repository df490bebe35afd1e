package faultline.control.diagnosis;

import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;

/**
 * The robot's pose by dead reckoning: the controller's own voltages through the motor's model. In a frame in which the
 * wall is kept on the left, whose origin is where the robot started.
 */
public final class DeadReckoning {

    private double x;
    private double y;
    private double heading;
    private WheelSpeeds wheelSpeeds = WheelSpeeds.ZERO;
    private double headingCos = 1;
    private double headingSin;
    private RobotSpec motorOf;
    private double decayDt;
    private double decay;
    private double rolled;
    private double turned;

    /**
     * Lets voltages act for some ticks.
     *
     * @param robot the robot as the controller believes it to be
     * @param leftVolts of the side next to the wall
     * @param rightVolts of the other side
     * @param dt the length of a tick, seconds
     * @param ticks how many
     */
    void advance(RobotSpec robot, double leftVolts, double rightVolts, double dt, long ticks) {
        MotorSpec motor = robot.motor();
        rolled = 0;
        turned = 0;
        if (robot != motorOf || dt != decayDt) {
            motorOf = robot;
            decayDt = dt;
            decay = motor.decay(dt);
        }
        for (long i = 0; i < ticks; i++) {
            wheelSpeeds = motor.step(wheelSpeeds, leftVolts, rightVolts, decay);
            Velocity velocity = wheelSpeeds.toVelocity(robot.track());
            double way = velocity.linear() * dt;
            double turn = velocity.angular() * dt;
            // The direction at the middle of the arc, to second order in the turn of a tick.
            double cos = ticks == 1 ? headingCos : StrictMath.cos(heading);
            double sin = ticks == 1 ? headingSin : StrictMath.sin(heading);
            double half = turn / 2;
            double shrink = 1 - half * half / 2;
            x += way * (cos * shrink - sin * half);
            y += way * (sin * shrink + cos * half);
            heading += turn;
            rolled += way;
            turned += turn;
        }
        headingCos = StrictMath.cos(heading);
        headingSin = StrictMath.sin(heading);
    }

    /**
     * The position ahead of the start.
     *
     * @return metres
     */
    public double x() {
        return x;
    }

    /**
     * The position to the left of the start.
     *
     * @return metres
     */
    public double y() {
        return y;
    }

    /**
     * All turning so far.
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
     * The distance rolled in the last step.
     *
     * @return metres, negative backwards
     */
    public double rolled() {
        return rolled;
    }

    /**
     * The turn of the last step.
     *
     * @return radians, positive to the left
     */
    public double turned() {
        return turned;
    }

    /**
     * The rate of turning now.
     *
     * @param robot the robot as the controller believes it to be
     * @return radians per second, positive to the left
     */
    public double omega(RobotSpec robot) {
        return wheelSpeeds.toVelocity(robot.track()).angular();
    }

    /**
     * The linear velocity now.
     *
     * @return metres per second
     */
    public double v() {
        return wheelSpeeds.linear();
    }
}
