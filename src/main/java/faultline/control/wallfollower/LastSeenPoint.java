package faultline.control.wallfollower;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;

/**
 * The nearest thing that one sensor has seen on a straight way, though it may have slipped out of its cone since. What
 * a robot passes leaves a cone at its rear edge, so that is where it was when it was seen last: a corner, say, that is
 * between two cones now.
 */
final class LastSeenPoint {

    private static final Vector2 NOT_SEEN = new Vector2(Reading.NOTHING, Reading.NOTHING);

    private Vector2 mountPosition = Vector2.ZERO;
    private Vector2 fromMount = NOT_SEEN;

    /** Takes a reading after a piece of straight way; what is behind the mounting position by now is forgotten. */
    void update(SensorView eye, double rolled) {
        fromMount = new Vector2(fromMount.x() - rolled, fromMount.y());
        if (fromMount.x() < 0) {
            clear();
        }
        // As near as was to be expected, or nearer: it is still in sight. Farther: something else is.
        if (eye.detects() && eye.reading() <= fromMount.length()) {
            double side = eye.bearing() < 0 ? -1 : 1;
            mountPosition = eye.mountPosition();
            fromMount = Vector2.direction(eye.bearing() + side * eye.halfCone()).times(eye.reading());
        }
    }

    void clear() {
        fromMount = NOT_SEEN;
    }

    /** How far it will be from the robot's centre after some more way, metres; infinite where nothing was seen. */
    double distanceAfter(double rolled) {
        return mountPosition.plus(fromMount).minus(new Vector2(rolled, 0)).length();
    }
}
