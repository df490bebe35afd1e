package faultline.robot;

/**
 * How the true drive differs from what the controller believes. The controller never sees it; with odometry from
 * commands alone these are the systematic errors of Borenstein and Feng (IEEE Transactions on Robotics and Automation
 * 12, 1996): unequal wheels and an uncertain wheelbase.
 *
 * @param left the true speed of the left wheels by the believed one
 * @param right the true speed of the right wheels by the believed one
 * @param track the true distance between the wheels by the believed one
 */
public record DriveScale(double left, double right, double track) {

    /** A drive as the controller believes it to be. */
    public static final DriveScale NONE = new DriveScale(1, 1, 1);

    /** The least factor allowed. */
    public static final double MIN = 0.1;

    /** The greatest factor allowed. */
    public static final double MAX = 10;

    /**
     * Creates a drive scale.
     *
     * @param left the true speed of the left wheels by the believed one
     * @param right the true speed of the right wheels by the believed one
     * @param track the true distance between the wheels by the believed one
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
