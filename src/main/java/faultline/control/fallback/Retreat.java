package faultline.control.fallback;

/**
 * A short way back from a surface right ahead that no trusted sensor sees all of: the robot needs room to turn on the
 * spot.
 */
final class Retreat {

    /** The length of the way, metres. */
    private static final double LENGTH = 0.1;

    private double left;

    /** Starts it, from its beginning. */
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
