package faultline.gui.canvas.tool;

import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.Clearance;
import faultline.world.Obstacle;
import faultline.world.Snapshot;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;

/** Whether the robot leaves room for something, as far as the frame that shows can tell. */
public final class PlacementCheck {

    private PlacementCheck() {}

    /** Whether an obstacle would overlap the robot. */
    public static boolean overlapsRobot(CanvasModel scene, Obstacle obstacle) {
        return scene.frame()
                .filter(frame -> findObstruction(
                                frame.snapshot().robot(),
                                frame.snapshot().pose(),
                                false,
                                frame.snapshot(),
                                List.of(obstacle))
                        .isPresent())
                .isPresent();
    }

    /** What the robot would overlap at a pose; outside of an enclosed world, that is the wall round it. */
    static Optional<String> findObstruction(Snapshot world, Pose pose) {
        boolean inside = pose.x() > 0 && pose.x() < world.width() && pose.y() > 0 && pose.y() < world.height();
        if (world.enclosed() && !inside) {
            return Optional.of(WorldSpec.ENCLOSURE);
        }
        return findObstruction(world.robot(), pose, world.enclosed(), world, world.obstacles());
    }

    private static Optional<String> findObstruction(
            RobotSpec robot, Pose pose, boolean enclosed, Snapshot world, List<Obstacle> obstacles) {
        return Clearance.findObstruction(
                new WorldSpec(world.width(), world.height(), enclosed, obstacles.size(), obstacles), robot, pose);
    }
}
