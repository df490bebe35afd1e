package faultline.control;

import java.util.Locale;

/** The side of the robot on which the wall is. */
public enum WallSide {
    /** The wall is on the robot's left, as in the paper. */
    LEFT,
    /** The wall is on the robot's right. */
    RIGHT;

    /** {@return the name in scenario files, in lower case} */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT);
    }
}
