package faultline.world;

import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import java.util.Optional;

/** Checks whether the robot has room at a pose, before a run or before an edit. */
public final class Clearance {

    /** A body nearer than this to an obstacle counts as touching it, metres. */
    public static final double MIN_DISTANCE = 1e-9;

    private Clearance() {}

    /**
     * {@return the id of the first obstacle, or {@link WorldSpec#ENCLOSURE}, that the robot would touch or overlap at a
     * pose} Everything outside of an enclosed world belongs to the enclosure.
     *
     * @param world the world at the start
     * @param robot the robot
     * @param pose the robot's pose
     */
    public static Optional<String> findObstruction(WorldSpec world, RobotSpec robot, Pose pose) {
        boolean inside = pose.x() >= 0 && pose.x() <= world.width() && pose.y() >= 0 && pose.y() <= world.height();
        if (world.enclosed() && !inside) {
            return Optional.of(WorldSpec.ENCLOSURE);
        }
        return ObstacleSet.findObstruction(
                world, world.obstacles(), new OrientedBox(pose, robot.length(), robot.width()));
    }
}
