package faultline.control.fallback;

import faultline.geometry.Angles;

/**
 * The direction of the followed wall from the robot, and how far the robot has rolled since it saw the wall. Directions
 * are in radians in the frame of the map, counter-clockwise, and change without jumps while the same wall is followed.
 */
final class WallBearing {

    /** A wall that the robot has not seen for this distance is lost, metres. */
    private static final double LOST_AFTER = 1.2;

    /** A surface whose direction differs from that of the wall by at most this can be the wall, radians. */
    private static final double SECTOR = StrictMath.toRadians(75);

    private final LocalMap map;
    private double direction;
    private double rolledUnseen;

    WallBearing(LocalMap map) {
        this.map = map;
    }

    /**
     * Begins with a wall that has not been seen yet.
     *
     * @param expected its direction
     * @param atWall whether the robot is at it: the wall is lost only after a while
     */
    void begin(double expected, boolean atWall) {
        direction = expected;
        rolledUnseen = atWall ? LOST_AFTER / 2 : LOST_AFTER + 1;
    }

    /** Adds a distance that the robot has rolled, metres. */
    void advance(double rolled) {
        rolledUnseen += Math.abs(rolled);
    }

    /** Returns the direction of the wall, or the last one if no wall is seen. */
    double direction() {
        return direction;
    }

    boolean isLost() {
        return rolledUnseen > LOST_AFTER;
    }

    /** Updates the direction to that of the nearest surface near the last direction and within a distance, metres. */
    void follow(double within) {
        double seen = map.bearingOfSurface(direction, SECTOR, within);
        if (!Double.isNaN(seen)) {
            direction += Angles.difference(direction, seen);
            rolledUnseen = 0;
        }
    }

    /**
     * Takes the nearest surface all around as the wall, if there is one within a distance.
     *
     * @param ahead the direction of the path
     * @param within metres
     */
    void find(double ahead, double within) {
        double seen = map.bearingOfSurface(ahead, StrictMath.PI, within);
        if (!Double.isNaN(seen)) {
            direction = seen;
            rolledUnseen = 0;
        }
    }

    /**
     * Takes the nearest surface near a direction as the wall; if there is none within a distance, the wall does not
     * change.
     *
     * @param towards the direction
     * @param within metres
     */
    void replace(double towards, double within) {
        double seen = map.bearingOfSurface(towards, SECTOR, within);
        direction = Double.isNaN(seen) ? direction : seen;
    }
}
