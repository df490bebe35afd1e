package faultline.world;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.Optional;

/**
 * The whole world at the end of one tick; immutable, so that any thread may keep it.
 *
 * @param tick how many ticks have passed
 * @param time tick times dt, seconds
 * @param width the world's, metres
 * @param height the world's, metres
 * @param enclosed whether a wall runs round it
 * @param robot as it is built and set now
 * @param pose the robot's
 * @param leftSpeed of the left wheels, metres per second
 * @param rightSpeed of the right wheels, metres per second
 * @param sensors in the robot's order
 * @param obstacles as they stand now, in drawing order
 * @param contacts where the robot touches obstacles, metres; empty before a collision
 * @param collision the first contact, empty before it
 */
public record Snapshot(
        long tick,
        double time,
        double width,
        double height,
        boolean enclosed,
        RobotSpec robot,
        Pose pose,
        double leftSpeed,
        double rightSpeed,
        List<SensorSnapshot> sensors,
        List<Obstacle> obstacles,
        List<Vector2> contacts,
        Optional<Collision> collision) {

    public Snapshot {
        sensors = List.copyOf(sensors);
        obstacles = List.copyOf(obstacles);
        contacts = List.copyOf(contacts);
    }

    /**
     * The robot's linear velocity.
     *
     * @return metres per second
     */
    public double v() {
        return (rightSpeed + leftSpeed) / 2;
    }

    /**
     * The robot's angular velocity.
     *
     * @return radians per second, positive to the left
     */
    public double omega() {
        return (rightSpeed - leftSpeed) / robot.track();
    }
}
