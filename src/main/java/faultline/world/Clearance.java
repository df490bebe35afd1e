package faultline.world;

import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import java.util.Optional;

/** Whether the robot has room where it stands: asked before a run, and before a command puts something where it is. */
public final class Clearance {

    /** A body nearer than this to an obstacle counts as touching it, metres. */
    public static final double MIN_DISTANCE = 1e-9;

    private Clearance() {}

    /**
     * What the robot would overlap or touch at a pose.
     *
     * @param world the world before anything moves
     * @param robot the robot as built
     * @param pose where it stands
     * @return the id of the first such obstacle, or {@link WorldSpec#ENCLOSURE}; empty where the robot has room
     */
    public static Optional<String> findObstruction(WorldSpec world, RobotSpec robot, Pose pose) {
        String id = new ObstacleSet(world).findObstruction(new OrientedBox(pose, robot.length(), robot.width()));
        return id.isEmpty() ? Optional.empty() : Optional.of(id);
    }
}
