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
     * The distance from the robot's centre to the wall ahead.
     *
     * @param sight the sensors
     * @param mostLeft how far it may be slanted with its foot to the left, radians
     * @param mostRight how far it may be slanted with its foot to the right, radians
     * @return metres, positive infinity where the front sensor sees nothing
     */
    static double distance(Sight sight, double mostLeft, double mostRight) {
        if (!sight.front().sees()) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.min(nearest(sight.front(), sight.frontLeft(), mostLeft), nearest(sight.front(), sight.frontRight(), -mostRight));
    }

    /** The foot distance of the most slanted wall, between square and a limit, that the side sensor does not contradict. */
    private static double nearest(Eye front, Eye side, double limit) {
        double square = front.wallDistance(0);
        if (!side.present() || square < side.wallDistance(0)) {
            return square;
        }
        double possible = 0;
        double beyond = limit;
        if (front.wallDistance(limit) >= side.wallDistance(limit)) {
            return front.wallDistance(limit);
        }
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (possible + beyond) / 2;
            if (front.wallDistance(middle) >= side.wallDistance(middle)) {
                possible = middle;
            } else {
                beyond = middle;
            }
        }
        return front.wallDistance(possible);
    }
}
