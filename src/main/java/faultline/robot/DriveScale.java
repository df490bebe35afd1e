package faultline.robot;

/**
 * The difference between the true drive and the model of the controller. The controller never sees it; with odometry
 * from commands alone these are the systematic errors of Borenstein and Feng (IEEE Transactions on Robotics and
 * Automation 12, 1996): unequal wheels and an uncertain wheelbase.
 *
 * @param left the true speed of the left wheels divided by that of the model
 * @param right the true speed of the right wheels divided by that of the model
 * @param track the true distance between the wheels divided by that of the model
 */
public record DriveScale(double left, double right, double track) {

    /** A drive as the controller believes it to be. */
    public static final DriveScale NONE = new DriveScale(1, 1, 1);

    /** The minimum factor. */
    public static final double MIN = 0.1;

    /** The maximum factor. */
    public static final double MAX = 10;

    /**
     * Creates a drive scale.
     *
     * @param left the true speed of the left wheels divided by that of the model
     * @param right the true speed of the right wheels divided by that of the model
     * @param track the true distance between the wheels divided by that of the model
     * @throws IllegalArgumentException if a factor is outside its limits
     */
    public DriveScale {
        requireScale("left", left);
        requireScale("right", right);
        requireScale("track", track);
    }

    /** {@return whether the drive is as the controller believes it to be} */
    public boolean isNone() {
        return left == 1 && right == 1 && track == 1;
    }

    private static void requireScale(String name, double value) {
        if (!(value >= MIN && value <= MAX)) {
            throw new IllegalArgumentException(
                    "the " + name + " scale must be from " + MIN + " to " + MAX + ": " + value);
        }
    }
}
