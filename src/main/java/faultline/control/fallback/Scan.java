package faultline.control.fallback;

/**
 * A turn on the spot by which a sensor sees unknown ground. Several scans in a row may serve one step of the robot:
 * what they have not shown then counts as a surface.
 */
final class Scan {

    /** The maximum number of scans in a row. */
    private static final int MAX_IN_A_ROW = 4;

    /** Places that are this near to each other are the same, metres. */
    private static final double SAME_PLACE = 0.05;

    /** The turn continues by this after the axis of the sensor has pointed at the place, radians. */
    private static final double OVERSHOOT = StrictMath.toRadians(30);

    private boolean active;
    private double turn;
    private double turned;
    private double margin;
    private double x;
    private double y;
    private int inARow;

    /**
     * Starts a scan.
     *
     * @param toPlace the turn after which the axis of the sensor points at the place, radians; not a number if no
     *     sensor can see it
     * @param marginAngle by how much further clockwise the path must be known as well, radians
     * @param px the place
     * @param py the place
     */
    void start(double toPlace, double marginAngle, double px, double py) {
        active = true;
        inARow++;
        turned = 0;
        turn = Double.isNaN(toPlace) ? 0 : toPlace + Math.copySign(OVERSHOOT, toPlace);
        margin = marginAngle;
        x = px;
        y = py;
    }

    boolean isActive() {
        return active;
    }

    /** Returns by how much further clockwise the path must be known as well, radians. */
    double margin() {
        return margin;
    }

    /** Returns the direction of the turn, 1 if it is counter-clockwise, otherwise -1. */
    double sign() {
        return Math.copySign(1, turn);
    }

    /** Adds a turn of the robot, and returns whether the sensor has passed the place. */
    boolean advance(double radians) {
        turned += radians;
        return Math.abs(turned) >= Math.abs(turn);
    }

    void end() {
        active = false;
    }

    /** Forgets the scans in a row, because the robot drives on. */
    void forget() {
        inARow = 0;
    }

    /** Returns whether another scan can show another place. */
    boolean mayContinueAt(double px, double py) {
        double dx = px - x;
        double dy = py - y;
        return inARow < MAX_IN_A_ROW && dx * dx + dy * dy > SAME_PLACE * SAME_PLACE;
    }
}
