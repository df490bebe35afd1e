package faultline.world;

import faultline.geometry.ConvexShape;
import java.util.List;

/** A static obstacle with its geometry. It never changes: an edit replaces it by another with the same order. */
class PlacedObstacle extends ShapeOwner {

    private final Obstacle obstacle;
    private final ObstacleGeometry geometry;
    private final double boundingRadius;

    PlacedObstacle(Obstacle obstacle, long order) {
        super(obstacle.id(), order, obstacle.specularAngle());
        this.obstacle = obstacle;
        this.geometry = ObstacleGeometry.of(obstacle);
        // Rounding must not hide a part that just reaches.
        boundingRadius = obstacle.shape().boundingRadius() * (1 + 1e-9) + 1e-9;
    }

    /** Returns the obstacle at its current pose. */
    Obstacle obstacle() {
        return obstacle;
    }

    /** Returns the current geometry. */
    ObstacleGeometry geometry() {
        return geometry;
    }

    List<ConvexShape> parts() {
        return geometry().parts();
    }

    /** Returns the radius of a circle about the pose's position that encloses the outline, metres. */
    double boundingRadius() {
        return boundingRadius;
    }
}
