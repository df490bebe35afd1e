package faultline.control.diagnosis;

/** The distance that the robot has rolled and the angle that it has turned, in the last step and since the start. */
final class MotionAccumulator {

    private double rolled;
    private double turned;
    private double netDistance;
    private double heading;

    /** Adds a step. */
    void advance(double rolledBy, double turnedBy) {
        rolled = rolledBy;
        turned = turnedBy;
        netDistance += rolledBy;
        heading += turnedBy;
    }

    /** Returns the distance rolled in the last step, metres, negative backwards. */
    double rolled() {
        return rolled;
    }

    /** Returns the turn of the last step, radians, positive to the left. */
    double turned() {
        return turned;
    }

    /** Returns the distance rolled forwards less that rolled backwards, metres. */
    double netDistance() {
        return netDistance;
    }

    /** Returns the total turn, radians, positive to the left. */
    double heading() {
        return heading;
    }
}
