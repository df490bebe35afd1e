package faultline.control.fallback;

/**
 * A short drive away from a surface directly ahead that no trusted sensor sees completely, because the robot needs room
 * to turn on the spot.
 */
final class Retreat {

    /** The length of the drive, metres. */
    private static final double LENGTH = 0.1;

    private double left;

    /** Starts a new drive. */
    void start() {
        left = LENGTH;
    }

    void end() {
        left = 0;
    }

    boolean isActive() {
        return left > 0;
    }

    /** Adds a distance that the robot has rolled, metres. */
    void advance(double rolled) {
        left -= Math.abs(rolled);
    }
}
