package faultline.world;

import faultline.geometry.Pose;
import java.util.Objects;
import java.util.Optional;

/**
 * An obstacle as it stands at one moment.
 *
 * @param id unique in its world
 * @param shape in its own frame
 * @param pose of that frame in the world
 * @param motion its way-points, empty for a static obstacle
 */
public record Obstacle(String id, ObstacleShape shape, Pose pose, Optional<Motion> motion) {

    public Obstacle {
        if (id.isEmpty()) {
            throw new IllegalArgumentException("an obstacle needs an id");
        }
        Objects.requireNonNull(shape, "shape");
        Objects.requireNonNull(pose, "pose");
        Objects.requireNonNull(motion, "motion");
    }

    /**
     * A static obstacle.
     *
     * @param id unique in its world
     * @param shape in its own frame
     * @param pose of that frame in the world
     */
    public Obstacle(String id, ObstacleShape shape, Pose pose) {
        this(id, shape, pose, Optional.empty());
    }

    /**
     * This obstacle somewhere else.
     *
     * @param elsewhere the new pose
     * @return the same obstacle otherwise
     */
    public Obstacle at(Pose elsewhere) {
        return new Obstacle(id, shape, elsewhere, motion);
    }
}
