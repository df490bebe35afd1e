package faultline.control;

/**
 * How far the robot's centre is from the wall ahead, whatever the angle at which that wall crosses the way.
 *
 * <p>One front reading fits a wall of any angle: the more slanted, the nearer its foot. A sensor looking aside settles it, because a wall slanted to that side would show
 * there no farther than it does. The answer is the distance of the most slanted wall that contradicts no sensor; with nothing to tell, the wall is taken as square.
 */
final class WallAhead {

    /**
     * Along a wall, walls ahead are taken to be slanted by no more than this: inner corners from 35 to 155 degrees are measured. With more, the side walls of a narrow
     * passage would count as slanted walls ahead.
     */
    static final double MOST_LEFT = StrictMath.toRadians(65);
    static final double MOST_RIGHT = StrictMath.toRadians(55);

    /** In the open any slant is possible that the front sensor can see. */
    static final double MOST_IN_THE_OPEN = StrictMath.toRadians(78);

    private static final int HALVINGS = 12;

    private WallAhead() {
    }

    /**
     * The distance from the robot's centre to the wall ahead when it has rolled on.
     *
     * @param rolled how far, metres
     * @param sight the sensors
     * @param mostLeft how far it may be slanted with its foot to the left, radians
     * @param mostRight how far it may be slanted with its foot to the right, radians
     * @return metres, positive infinity where the front sensor sees nothing
     */
    static double distanceAfter(double rolled, Sight sight, double mostLeft, double mostRight) {
        if (!sight.front().sees()) {
            return Double.POSITIVE_INFINITY;
        }
        double left = slant(sight.front(), sight.frontLeft(), mostLeft);
        double right = slant(sight.front(), sight.frontRight(), -mostRight);
        return Math.min(sight.front().wallDistance(left) - rolled * StrictMath.cos(left),
                sight.front().wallDistance(right) - rolled * StrictMath.cos(right));
    }

    /** The bearing of the foot of the most slanted wall, between square and a limit, that the side sensor does not contradict. */
    private static double slant(Eye front, Eye side, double limit) {
        if (!side.present() || contradicts(side, front, 0)) {
            return 0;
        }
        if (!contradicts(side, front, limit)) {
            return limit;
        }
        double possible = 0;
        double beyond = limit;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (possible + beyond) / 2;
            if (contradicts(side, front, middle)) {
                beyond = middle;
            } else {
                possible = middle;
            }
        }
        return possible;
    }

    /** A wall at this bearing that gives the front reading would show to the side sensor nearer than anything does. */
    private static boolean contradicts(Eye side, Eye front, double bearing) {
        return front.wallDistance(bearing) < side.wallDistance(bearing);
    }
}
