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
 * @param specular the greatest angle of incidence that its surface sends light back from, radians from the normal, in (0, pi / 2]; {@link #MATT} for all
 */
public record Obstacle(String id, ObstacleShape shape, Pose pose, Optional<Motion> motion, double specular) {

    /** A surface that is seen at any angle. */
    public static final double MATT = StrictMath.PI / 2;

    public Obstacle {
        if (id.isEmpty()) {
            throw new IllegalArgumentException("an obstacle needs an id");
        }
        Objects.requireNonNull(shape, "shape");
        Objects.requireNonNull(pose, "pose");
        Objects.requireNonNull(motion, "motion");
        if (!(specular > 0 && specular <= MATT)) {
            throw new IllegalArgumentException("specular must be more than 0 and at most a right angle: " + specular);
        }
        if (specular < MATT && (shape instanceof ObstacleShape.Circle || shape instanceof ObstacleShape.Ellipse)) {
            throw new IllegalArgumentException("only flat surfaces can be specular: " + id);
        }
    }

    /**
     * An obstacle with a matt surface.
     *
     * @param id unique in its world
     * @param shape in its own frame
     * @param pose of that frame in the world
     * @param motion its way-points, empty for a static obstacle
     */
    public Obstacle(String id, ObstacleShape shape, Pose pose, Optional<Motion> motion) {
        this(id, shape, pose, motion, MATT);
    }

    /**
     * A static obstacle with a matt surface.
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
        return new Obstacle(id, shape, elsewhere, motion, specular);
    }
}
