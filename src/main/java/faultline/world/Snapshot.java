package faultline.world;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFaults;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.List;
import java.util.Optional;

/**
 * The whole world at the end of one tick. Immutable and safe on any thread.
 *
 * @param tick the number of ticks that have passed
 * @param time tick times dt, seconds
 * @param width the width of the world, metres
 * @param height the height of the world, metres
 * @param enclosed whether a wall encloses the world
 * @param robot the robot's current construction and settings
 * @param pose the pose of the robot; its heading is not normalised
 * @param wheelSpeeds the speeds of the robot's wheels
 * @param motorFaults the faults of the robot's motors
 * @param sensors the sensors, in the robot's order
 * @param obstacles the obstacles, in drawing order
 * @param contacts the points where the robot touches obstacles, metres; empty before a collision
 * @param collisions the robot's first contact; empty before it, and never more than one
 */
public record Snapshot(
        long tick,
        double time,
        double width,
        double height,
        boolean enclosed,
        RobotSpec robot,
        Pose pose,
        WheelSpeeds wheelSpeeds,
        MotorFaults motorFaults,
        List<SensorSnapshot> sensors,
        List<Obstacle> obstacles,
        List<Vector2> contacts,
        List<Collision> collisions) {

    /**
     * Creates a snapshot from copies of the lists.
     *
     * @param tick the number of ticks that have passed
     * @param time tick times dt, seconds
     * @param width the width of the world, metres
     * @param height the height of the world, metres
     * @param enclosed whether a wall encloses the world
     * @param robot the robot's current construction and settings
     * @param pose the pose of the robot; its heading is not normalised
     * @param wheelSpeeds the speeds of the robot's wheels
     * @param motorFaults the faults of the robot's motors
     * @param sensors the sensors, in the robot's order
     * @param obstacles the obstacles, in drawing order
     * @param contacts the points where the robot touches obstacles, metres; empty before a collision
     * @param collisions the robot's first contact; empty before it, and never more than one
     */
    public Snapshot {
        sensors = List.copyOf(sensors);
        obstacles = ObstacleSet.PlacedList.copyOf(obstacles);
        contacts = List.copyOf(contacts);
        collisions = List.copyOf(collisions);
    }

    /** {@return the robot's first contact} */
    public Optional<Collision> collision() {
        return collisions.stream().findFirst();
    }

    /** {@return the robot's velocity} */
    public Velocity velocity() {
        return wheelSpeeds.toVelocity(robot.trueTrack());
    }
}
