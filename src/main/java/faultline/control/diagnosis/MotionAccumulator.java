package faultline.control.diagnosis;

/** The distance that the robot has rolled and the angle that it has turned, in the last step and since the start. */
final class MotionAccumulator {

    private double rolled;
    private double turned;
    private double unsteadiness;
    private double netDistance;
    private double heading;
    private int steps;

    /** Adds a step. */
    void advance(double rolledBy, double turnedBy) {
        unsteadiness = Math.abs(turnedBy - turned);
        rolled = rolledBy;
        turned = turnedBy;
        netDistance += rolledBy;
        heading += turnedBy;
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

    /** Returns by how much the turn of the last step differs from that of the one before it, radians. */
    double unsteadiness() {
        return unsteadiness;
    }

    /** Returns the distance rolled forwards less that rolled backwards, metres. */
    double netDistance() {
        return netDistance;
    }

    /** Returns the total turn, radians, positive to the left. */
    double heading() {
        return heading;
    }

    /** Returns the number of steps. */
    int steps() {
        return steps;
    }
}
