package faultline.control;

import java.util.Locale;

/** The side on which the wall is kept. */
public enum WallSide {
    /** The wall is on the robot's left, as in the paper. */
    LEFT,
    /** The wall is on the robot's right. */
    RIGHT;

    /**
     * The name in scenario files.
     *
     * @return lower case
     */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT);
    }
}
