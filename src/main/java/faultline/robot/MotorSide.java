package faultline.robot;

import java.util.Locale;

/** The motors of one side of the robot, which turn together. */
public enum MotorSide {
    LEFT,
    RIGHT;

    /** Returns the name in scenario files, in lower case. */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT);
    }
}
