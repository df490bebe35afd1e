package faultline.world;

import faultline.geometry.ConvexShape;
import java.util.List;

/** A static obstacle with its geometry. It never changes: an edit replaces it by another with the same order. */
class PlacedObstacle extends ShapeOwner {

    private final Obstacle obstacle;
    private final ObstacleGeometry geometry;

    PlacedObstacle(Obstacle obstacle, long order) {
        super(obstacle.id(), order, obstacle.specularAngle());
        this.obstacle = obstacle;
        this.geometry = ObstacleGeometry.of(obstacle);
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
}
