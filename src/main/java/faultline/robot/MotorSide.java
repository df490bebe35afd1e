package faultline.robot;

import java.util.Locale;

/** The motors of one side of the robot, which turn together. */
public enum MotorSide {
    /** The motors of the left wheels. */
    LEFT,
    /** The motors of the right wheels. */
    RIGHT;

    /** {@return the name in scenario files, in lower case} */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT);
    }
}
