package faultline.gui.edit;

/** The limits of numbers that several controls of the window change. They are narrower than those of files. */
public final class EditLimits {

    /** The shortest range of a sensor, metres. */
    public static final double MIN_SENSOR_RANGE = 0.01;

    /** The longest range of a sensor, metres. */
    public static final double MAX_SENSOR_RANGE = 100;

    /** The greatest absolute value of a heading or a bearing, degrees. */
    public static final double MAX_ANGLE = 360;

    private EditLimits() {}
}
