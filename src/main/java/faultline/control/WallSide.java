package faultline.control;

import faultline.robot.WheelSpeeds;
import java.util.Locale;

/** The side of the robot on which the wall is. */
public enum WallSide {
    /** The wall is on the robot's left, as in the paper. */
    LEFT(1),
    /** The wall is on the robot's right. */
    RIGHT(-1);

    private final double sign;

    WallSide(double sign) {
        this.sign = sign;
    }

    /**
     * {@return the factor of y coordinates and of angles that moves the wall to the robot's left: 1, or -1 if it is on
     * the right}
     */
    public double sign() {
        return sign;
    }

    /**
     * {@return the speeds of the wheels in a frame in which the wall is on the left: those of the side of the wall as
     * the left ones}
     *
     * @param wheels the speeds of the left and the right wheels of the robot
     */
    public WheelSpeeds nearAndFar(WheelSpeeds wheels) {
        return this == LEFT ? wheels : new WheelSpeeds(wheels.right(), wheels.left());
    }

    /** {@return the name in scenario files, in lower case} */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT);
    }
}
