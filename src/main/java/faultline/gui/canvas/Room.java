package faultline.gui.canvas;

import faultline.robot.RobotSpec;
import faultline.geometry.Pose;
import faultline.world.Clearance;
import faultline.world.Obstacle;
import faultline.world.Snapshot;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;

/** Whether the robot leaves room for something, as far as the frame that shows can tell. */
final class Room {

    private Room() {
    }

    /** Whether an obstacle would overlap the robot. */
    static boolean isBlocked(Scene scene, Obstacle obstacle) {
        return scene.frame().filter(frame -> obstructing(frame.world().robot(), frame.world().pose(), false, frame.world(),
                List.of(obstacle)).isPresent())
                .isPresent();
    }

    /** What the robot would overlap at a pose; outside of an enclosed world, that is the wall round it. */
    static Optional<String> obstructing(Snapshot world, Pose pose) {
        boolean inside = pose.x() > 0 && pose.x() < world.width() && pose.y() > 0 && pose.y() < world.height();
        if (world.enclosed() && !inside) {
            return Optional.of(WorldSpec.ENCLOSURE);
        }
        return obstructing(world.robot(), pose, world.enclosed(), world, world.obstacles());
    }

    private static Optional<String> obstructing(RobotSpec robot, Pose pose, boolean enclosed, Snapshot world, List<Obstacle> obstacles) {
        return Clearance.obstructing(new WorldSpec(world.width(), world.height(), enclosed, obstacles.size(), obstacles), robot, pose);
    }
}
