package faultline.control;

import faultline.geometry.Vec;
import faultline.sensor.Reading;

/**
 * The nearest thing that one sensor has seen on a straight way, though it may have slipped out of its cone since. What a robot passes
 * leaves a cone at its rear edge, so that is where it was when it was seen last: a corner, say, that is between two cones now.
 */
final class Glimpse {

    private static final Vec NOTHING = new Vec(Reading.NOTHING, Reading.NOTHING);

    private Vec seat = Vec.ZERO;
    private Vec fromSeat = NOTHING;

    /** Takes a reading after a piece of straight way; what is behind the seat by now is forgotten. */
    void update(Eye eye, double rolled) {
        fromSeat = new Vec(fromSeat.x() - rolled, fromSeat.y());
        if (fromSeat.x() < 0) {
            forget();
        }
        // As near as was to be expected, or nearer: it is still in sight. Farther: something else is.
        if (eye.sees() && eye.reading() <= fromSeat.length()) {
            double side = eye.bearing() < 0 ? -1 : 1;
            seat = eye.seat();
            fromSeat = Vec.direction(eye.bearing() + side * eye.halfCone()).times(eye.reading());
        }
    }

    void forget() {
        fromSeat = NOTHING;
    }

    /** How far it will be from the robot's centre after some more way, metres; infinite where nothing was seen. */
    double distanceAfter(double rolled) {
        return seat.plus(fromSeat).minus(new Vec(rolled, 0)).length();
    }
}
