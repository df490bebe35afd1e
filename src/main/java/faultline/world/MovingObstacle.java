package faultline.world;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;

/** An obstacle that follows its path. Its pose and geometry are computed on demand. */
final class MovingObstacle extends PlacedObstacle {

    private final WaypointFollower follower;
    private final RigidMotion frame;
    /** Encloses the outline about the position, metres. */
    private final double boundingRadius;

    private ObstacleGeometry current;

    MovingObstacle(Obstacle obstacle, long order) {
        super(obstacle, order);
        follower = new WaypointFollower(obstacle.motion(), obstacle.pose().position());
        current = super.geometry();
        frame = current.frame();
        // Rounding must not hide a part that is just within the distance.
        boundingRadius = obstacle.shape().boundingRadius() * (1 + 1e-9) + 1e-9;
    }

    /** Returns the obstacle at its current pose. */
    @Override
    Obstacle obstacle() {
        Obstacle start = super.obstacle();
        return start.withPose(new Pose(follower.x(), follower.y(), start.pose().heading()));
    }

    @Override
    ObstacleGeometry geometry() {
        if (current.frame().x() != follower.x() || current.frame().y() != follower.y()) {
            current = ObstacleGeometry.of(
                    super.obstacle().shape(), new RigidMotion(frame.cos(), frame.sin(), follower.x(), follower.y()));
        }
        return current;
    }

    WaypointFollower follower() {
        return follower;
    }

    /** Returns whether the circle about this obstacle comes within a distance of a point. */
    boolean isWithin(double x, double y, double distance) {
        double dx = follower.x() - x;
        double dy = follower.y() - y;
        double limit = distance + boundingRadius;
        return dx * dx + dy * dy <= limit * limit;
    }
}
