package faultline.control;

import faultline.geometry.Angles;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;

/**
 * The sensors that the follower uses, found by their bearing and not by their name, in a frame in which the wall is kept on the left. A
 * right-handed follower is a left-handed one in a mirror.
 *
 * @param left faces the wall; two sensors, this and {@code front}, follow most walls
 * @param front looks ahead
 * @param frontLeft tells an obtuse corner ahead from a square one
 * @param frontRight the third sensor, which an acute inner corner needs
 * @param right only guards a search
 */
record Sight(Eye left, Eye front, Eye frontLeft, Eye frontRight, Eye right) {

    /** A sensor serves for a direction if its bearing is at most this far off. */
    private static final double TOLERANCE = StrictMath.toRadians(20);

    private static final double QUARTER = StrictMath.PI / 2;

    /** The follower's sensors in an observation. */
    static Sight of(Observation observation, Hand hand) {
        double side = hand == Hand.LEFT ? 1 : -1;
        return new Sight(eye(observation, QUARTER, side), eye(observation, 0, side), eye(observation, QUARTER / 2, side),
                eye(observation, -QUARTER / 2, side), eye(observation, -QUARTER, side));
    }

    /** This sight with another front sensor. */
    Sight withFront(Eye other) {
        return new Sight(left, other, frontLeft, frontRight, right);
    }

    /** This sight with another front left sensor. */
    Sight withFrontLeft(Eye other) {
        return new Sight(left, front, other, frontRight, right);
    }

    private static Eye eye(Observation observation, double bearing, double side) {
        RobotSpec robot = observation.robot();
        int best = -1;
        double least = TOLERANCE;
        for (int i = 0; i < robot.sensors().size(); i++) {
            double off = Math.abs(Angles.difference(bearing, side * robot.sensors().get(i).bearing()));
            if (off < least && !Reading.isOff(observation.readings()[i])) {
                best = i;
                least = off;
            }
        }
        return best < 0 ? Eye.NONE : mirrored(robot.sensors().get(best), observation.readings()[best], side);
    }

    private static Eye mirrored(SensorSpec sensor, double reading, double side) {
        Vec seat = new Vec(sensor.seat().x(), side * sensor.seat().y());
        return new Eye(seat, Angles.normalize(side * sensor.bearing()), sensor.cone() / 2, sensor.range(), reading, true);
    }
}
