package faultline.control.wallfollower;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;

/**
 * The nearest point that one sensor has seen during straight motion, even if it has left the cone since. What the robot
 * passes leaves a cone at its rear edge, so the point was there when it was last seen: for example a corner that is now
 * between two cones.
 */
final class LastSeenPoint {

    private static final Vector2 NOT_SEEN = new Vector2(Reading.NOTHING, Reading.NOTHING);

    private Vector2 mountPosition = Vector2.ZERO;
    private Vector2 fromMount = NOT_SEEN;

    /** Processes a reading after some straight motion, and forgets what is behind the mounting position. */
    void update(SensorView view, double rolled) {
        fromMount = new Vector2(fromMount.x() - rolled, fromMount.y());
        if (fromMount.x() < 0) {
            clear();
        }
        // As near as expected, or nearer: the point is still in sight. Farther: another one is.
        if (view.detects() && view.reading() <= fromMount.length()) {
            double side = view.bearing() < 0 ? -1 : 1;
            mountPosition = view.mountPosition();
            fromMount =
                    Vector2.direction(view.bearing() + side * view.halfCone()).times(view.reading());
        }
    }

    void clear() {
        fromMount = NOT_SEEN;
    }

    /** Returns its distance from the robot's centre after some more motion, metres; infinite if nothing was seen. */
    double distanceAfter(double rolled) {
        return mountPosition.plus(fromMount).minus(new Vector2(rolled, 0)).length();
    }
}
