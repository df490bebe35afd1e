package faultline.control;

import faultline.robot.RobotSpec;

/**
 * What the controller is told at the end of a tick.
 *
 * @param tick how many ticks have passed
 * @param dt the length of a tick, seconds
 * @param robot the robot as it is built and set now
 * @param readings what each of the robot's sensors reports, in its order, encoded as in
 *     {@link faultline.sensor.Reading}; not to be changed, and valid until the next decision but one
 */
public record Observation(long tick, double dt, RobotSpec robot, double[] readings) {

    /**
     * Returns a sensor's distance, or another value if it sees nothing, does not answer or does not exist.
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
