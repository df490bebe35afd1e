package faultline.gui.canvas.tool;

import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.Clearance;
import faultline.world.Obstacle;
import faultline.world.Snapshot;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;

/** Checks whether there is room for an obstacle or the robot, in the frame that is shown. */
public final class PlacementCheck {

    private PlacementCheck() {}

    /** Returns whether an obstacle would overlap the robot. */
    public static boolean overlapsRobot(CanvasModel model, Obstacle obstacle) {
        return model.frame()
                .filter(frame -> overlapsRobot(frame.snapshot(), obstacle))
                .isPresent();
    }

    /** Returns whether an obstacle would overlap the robot of a world. */
    static boolean overlapsRobot(Snapshot world, Obstacle obstacle) {
        return findObstruction(world.robot(), world.pose(), false, world, List.of(obstacle))
                .isPresent();
    }

    /** Returns the id of what the robot would overlap at a pose; outside an enclosed world, that is the enclosure. */
    static Optional<String> findObstruction(Snapshot world, Pose pose) {
        return findObstruction(world.robot(), pose, world.enclosed(), world, world.obstacles());
    }

    private static Optional<String> findObstruction(
            RobotSpec robot, Pose pose, boolean enclosed, Snapshot world, List<Obstacle> obstacles) {
        return Clearance.findObstruction(
                new WorldSpec(world.width(), world.height(), enclosed, obstacles.size(), obstacles), robot, pose);
    }
}
