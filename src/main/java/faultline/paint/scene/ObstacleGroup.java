package faultline.paint.scene;

import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import java.awt.Shape;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;

/**
 * The bounds and the common centre of obstacles in the world, metres. If there are many they take long, so that what
 * paints obstacles in every frame keeps their group.
 */
public final class ObstacleGroup {

    /** The group without obstacles. */
    public static final ObstacleGroup NONE = new ObstacleGroup(List.of());

    private final List<Obstacle> obstacles;
    private final Vector2 centre;
    /** Null if there are no obstacles. */
    private final Rectangle2D bounds;

    private ObstacleGroup(List<Obstacle> obstacles) {
        this.obstacles = obstacles;
        Vector2 sum = Vector2.ZERO;
        Rectangle2D union = null;
        for (Obstacle obstacle : obstacles) {
            Shape local = ObstacleOutlines.localShape(obstacle.shape());
            sum = sum.plus(obstacle.pose().toParent(ObstacleOutlines.middle(local)));
            Rectangle2D own = RigidMotion.poseTransform(obstacle.pose())
                    .createTransformedShape(local)
                    .getBounds2D();
            union = union == null ? own : union.createUnion(own);
        }
        centre = obstacles.isEmpty() ? Vector2.ZERO : sum.times(1.0 / obstacles.size());
        bounds = union;
    }

    /** Returns the group of some obstacles. */
    public static ObstacleGroup of(List<Obstacle> obstacles) {
        return NONE.with(obstacles);
    }

    /** Returns the group of other obstacles; this group if they are equal to its own. */
    public ObstacleGroup with(List<Obstacle> others) {
        return obstacles == others || obstacles.equals(others) ? this : new ObstacleGroup(List.copyOf(others));
    }

    /** Returns the mean of the centres of the obstacles, at least one, about which the user rotates them. */
    Vector2 centre() {
        return centre;
    }

    /** Returns the smallest upright rectangle around all obstacles; empty if there are none. */
    Optional<Rectangle2D> bounds() {
        return Optional.ofNullable(bounds);
    }
}
