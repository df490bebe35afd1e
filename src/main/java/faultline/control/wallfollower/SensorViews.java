package faultline.control.wallfollower;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.geometry.Angles;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;

/**
 * The sensors that the follower uses, found by their bearings and not by their names, in a frame in which the wall is
 * on the left. A follower with the wall on the right is the mirror image of one with the wall on the left.
 *
 * @param left faces the wall; two sensors, this and {@code front}, follow most walls
 * @param front looks ahead
 * @param frontLeft distinguishes an obtuse corner ahead from a square one
 * @param frontRight the third sensor, which an acute inner corner needs
 * @param right used only in a search
 */
record SensorViews(SensorView left, SensorView front, SensorView frontLeft, SensorView frontRight, SensorView right) {

    /** A sensor is used for a direction if its bearing differs by at most this. */
    private static final double BEARING_TOLERANCE = StrictMath.toRadians(20);

    private static final double QUARTER_TURN = StrictMath.PI / 2;

    /** Returns the follower's sensors in an observation. */
    static SensorViews of(Observation observation, WallSide hand) {
        double side = hand == WallSide.LEFT ? 1 : -1;
        return new SensorViews(
                findView(observation, QUARTER_TURN, side),
                findView(observation, 0, side),
                findView(observation, QUARTER_TURN / 2, side),
                findView(observation, -QUARTER_TURN / 2, side),
                findView(observation, -QUARTER_TURN, side));
    }

    /** Returns these sensors with another front sensor. */
    SensorViews withFront(SensorView other) {
        return new SensorViews(left, other, frontLeft, frontRight, right);
    }

    /** Returns these sensors with another front left sensor. */
    SensorViews withFrontLeft(SensorView other) {
        return new SensorViews(left, front, other, frontRight, right);
    }

    private static SensorView findView(Observation observation, double bearing, double side) {
        RobotSpec robot = observation.robot();
        int best = -1;
        double least = BEARING_TOLERANCE;
        for (int i = 0; i < robot.sensors().size(); i++) {
            double off = Math.abs(
                    Angles.difference(bearing, side * robot.sensors().get(i).bearing()));
            if (off < least && !Reading.isOff(observation.readings()[i])) {
                best = i;
                least = off;
            }
        }
        return best < 0
                ? SensorView.NONE
                : toView(robot.sensors().get(best), observation.readings()[best], side);
    }

    private static SensorView toView(SensorSpec sensor, double reading, double side) {
        Vector2 mountPosition = new Vector2(
                sensor.mountPosition().x(), side * sensor.mountPosition().y());
        return new SensorView(
                mountPosition,
                Angles.normalize(side * sensor.bearing()),
                sensor.cone() / 2,
                sensor.range(),
                reading,
                true);
    }
}
