package faultline.control.wallfollower;

/**
 * Estimates the distance from the robot's centre to the wall ahead, at any angle of that wall.
 *
 * <p>One front reading fits walls of all angles: the more slanted the wall, the nearer its foot. A sensor that looks
 * aside decides, because a wall slanted to that side would give a reading there. The estimate is the most slanted wall
 * that contradicts no sensor; without such a sensor, the wall is assumed to be square to the path.
 *
 * @param front looks ahead
 * @param left looks ahead to the left
 * @param right looks ahead to the right
 */
record FrontWallEstimator(SensorView front, SensorView left, SensorView right) {

    /**
     * Along a wall, walls ahead are assumed to be slanted by at most this: inner corners from 35 to 155 degrees are
     * measured. If it were more, the side walls of a narrow passage would count as slanted walls ahead.
     */
    static final double MAX_LEFT_SLANT = StrictMath.toRadians(65);

    static final double MAX_RIGHT_SLANT = StrictMath.toRadians(55);

    /** Without a wall beside the robot, any slant is possible that the front sensor can see. */
    static final double MAX_SEARCH_SLANT = StrictMath.toRadians(78);

    private static final int BISECTION_STEPS = 12;

    /**
     * Returns whether the wall ahead will be within a distance of the robot's centre after some more motion.
     *
     * @param distance metres
     * @param rolled the distance that it still rolls, metres
     * @param mostLeft the maximum slant of the wall with its foot to the left, radians
     * @param mostRight the maximum slant of the wall with its foot to the right, radians
     * @return whether it will be; false if the front sensor sees nothing
     */
    boolean isWithin(double distance, double rolled, double mostLeft, double mostRight) {
        return front.detects()
                && (isWithin(distance, rolled, left, mostLeft) || isWithin(distance, rolled, right, -mostRight));
    }

    /** Checks the nearest wall that the front reading allows first, which decides in most cases. */
    private boolean isWithin(double distance, double rolled, SensorView side, double limit) {
        return distanceAfter(rolled, limit) <= distance
                && distanceAfter(rolled, maxPossibleSlant(side, limit)) <= distance;
    }

    private double distanceAfter(double rolled, double bearing) {
        return front.wallDistance(bearing) - rolled * StrictMath.cos(bearing);
    }

    /**
     * Returns the bearing of the foot of the most slanted wall, between square and a limit, that the side sensor does
     * not contradict.
     */
    private double maxPossibleSlant(SensorView side, double limit) {
        if (!side.present() || contradicts(side, 0)) {
            return 0;
        }
        if (!contradicts(side, limit)) {
            return limit;
        }
        double possible = 0;
        double beyond = limit;
        for (int i = 0; i < BISECTION_STEPS; i++) {
            double middle = (possible + beyond) / 2;
            if (contradicts(side, middle)) {
                beyond = middle;
            } else {
                possible = middle;
            }
        }
        return possible;
    }

    /**
     * Returns whether a wall at this bearing that gives the front reading would be nearer to the side sensor than
     * anything that it sees.
     */
    private boolean contradicts(SensorView side, double bearing) {
        return front.wallDistance(bearing) < side.wallDistance(bearing);
    }
}
