package faultline.world;

import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;

/**
 * Everything that can be done to a running world from outside: by a window, a scenario's timeline or a test. A command
 * is applied at the start of a tick and journaled with it. One that names something unknown, or would put an obstacle
 * or a larger platform where the robot and an obstacle overlap, is refused: it changes nothing, and says why (see
 * {@link World#execute}).
 */
public sealed interface Command {

    /**
     * Switches a sensor on or off.
     *
     * @param sensor the sensor's id
     * @param on the new state
     */
    record SwitchSensor(String sensor, boolean on) implements Command {}

    /**
     * Gives a sensor another seat, bearing, range, cone, switch and noise at once.
     *
     * @param sensor the new values; its id says which sensor
     */
    record ConfigureSensor(SensorSpec sensor) implements Command {}

    /**
     * Breaks a sensor in one more way.
     *
     * @param sensor the sensor's id
     * @param fault the fault, after those that it has already
     */
    record InjectFault(String sensor, Fault fault) implements Command {}

    /**
     * Mends one fault of a sensor.
     *
     * @param sensor the sensor's id
     * @param fault the fault; the oldest one equal to it goes
     */
    record ClearFault(String sensor, Fault fault) implements Command {}

    /**
     * Mends all faults of a sensor.
     *
     * @param sensor the sensor's id
     */
    record ClearFaults(String sensor) implements Command {}

    /**
     * Puts an obstacle somewhere else. One that would land on the robot is slid there along a straight line and stops
     * at first contact, which counts as a collision.
     *
     * @param obstacle the obstacle's id
     * @param pose where to
     */
    record MoveObstacle(String obstacle, Pose pose) implements Command {}

    /**
     * Adds an obstacle, or exchanges the one of the same id.
     *
     * @param obstacle the obstacle
     */
    record PlaceObstacle(Obstacle obstacle) implements Command {}

    /**
     * Takes an obstacle away.
     *
     * @param obstacle the obstacle's id
     */
    record RemoveObstacle(String obstacle) implements Command {}

    /**
     * Changes the robot's platform and linear velocity.
     *
     * @param length metres
     * @param width metres
     * @param speed metres per second
     */
    record SetPlatform(double length, double width, double speed) implements Command {
        public SetPlatform {
            RobotSpec.DEFAULT.withPlatform(length, width, speed);
        }
    }
}
