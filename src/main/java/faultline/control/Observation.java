package faultline.control;

import faultline.robot.RobotSpec;

/**
 * The input of the controller at the end of a tick.
 *
 * @param tick the number of ticks that have passed
 * @param dt the length of a tick, seconds
 * @param robot the robot with its current settings
 * @param readings the reading of each sensor, in the robot's order, encoded as in {@link faultline.sensor.Reading};
 *     must not be changed, and is valid until the next decision but one
 */
public record Observation(long tick, double dt, RobotSpec robot, double[] readings) {

    /**
     * {@return the distance that a sensor reports, metres, or another value if it sees nothing within range, does not
     * answer or does not exist}
     *
     * @param sensor the id of the sensor
     * @param otherwise the other value
     */
    public double distance(String sensor, double otherwise) {
        for (int i = 0; i < readings.length; i++) {
            if (robot.sensors().get(i).id().equals(sensor)) {
                return Double.isFinite(readings[i]) ? readings[i] : otherwise;
            }
        }
        return otherwise;
    }
}
