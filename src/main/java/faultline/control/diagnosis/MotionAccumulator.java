package faultline.control.diagnosis;

/** The distance that the robot has rolled and the angle that it has turned, in the last step and since the start. */
final class MotionAccumulator {

    /** The quantities that are accumulated. */
    enum Total {
        /** The distance rolled forwards less that rolled backwards, metres. */
        DISTANCE,
        /** The total turn, radians, positive to the left. */
        HEADING,
        /** The time, seconds. */
        TIME
    }

    private final double[] totals = new double[Total.values().length];
    private double rolled;
    private double turned;
    private double lasted;
    private double unsteadiness;
    private int steps;

    /**
     * Adds a step.
     *
     * @param rolledBy metres, negative backwards
     * @param turnedBy radians, positive to the left
     * @param dt seconds
     */
    void advance(double rolledBy, double turnedBy, double dt) {
        unsteadiness = Math.abs(turnedBy - turned);
        rolled = rolledBy;
        turned = turnedBy;
        lasted = dt;
        totals[Total.DISTANCE.ordinal()] += rolledBy;
        totals[Total.HEADING.ordinal()] += turnedBy;
        totals[Total.TIME.ordinal()] += dt;
        steps++;
    }

    /** Returns the distance rolled in the last step, metres, negative backwards. */
    double rolled() {
        return rolled;
    }

    /** Returns the turn of the last step, radians, positive to the left. */
    double turned() {
        return turned;
    }

    /** Returns the mean turn rate of the last step, radians per second, positive to the left. */
    double turnRate() {
        return turned / lasted;
    }

    /** Returns by how much the turn of the last step differs from that of the one before it, radians. */
    double unsteadiness() {
        return unsteadiness;
    }

    /** Returns a quantity since the start. */
    double total(Total which) {
        return totals[which.ordinal()];
    }

    /** Returns the distance rolled forwards less that rolled backwards, metres. */
    double netDistance() {
        return total(Total.DISTANCE);
    }

    /** Returns the total turn, radians, positive to the left. */
    double heading() {
        return total(Total.HEADING);
    }

    /** Returns the time since the start, seconds. */
    double time() {
        return total(Total.TIME);
    }

    /** Returns the number of steps. */
    int steps() {
        return steps;
    }
}
