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
 * @param specularAngle the greatest angle of incidence that its surface sends light back from, radians from the normal,
 *     in (0, pi / 2]; {@link #MATT} for all
 */
public record Obstacle(String id, ObstacleShape shape, Pose pose, Optional<WaypointPath> motion, double specularAngle) {

    /** A surface that is seen at any angle. */
    public static final double MATT = StrictMath.PI / 2;

    public Obstacle {
        if (id.isEmpty()) {
            throw new IllegalArgumentException("an obstacle needs an id");
        }
        Objects.requireNonNull(shape, "shape");
        Objects.requireNonNull(pose, "pose");
        Objects.requireNonNull(motion, "motion");
        if (!(specularAngle > 0 && specularAngle <= MATT)) {
            throw new IllegalArgumentException(
                    "specular must be more than 0 and at most a right angle: " + specularAngle);
        }
        if (specularAngle < MATT && (shape instanceof ObstacleShape.Circle || shape instanceof ObstacleShape.Ellipse)) {
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
    public Obstacle(String id, ObstacleShape shape, Pose pose, Optional<WaypointPath> motion) {
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
     * Whether its surface sends light back only where it is met steeply.
     *
     * @return false for a matt surface
     */
    public boolean isSpecular() {
        return specularAngle < MATT;
    }

    /**
     * This obstacle of another shape.
     *
     * @param changed the new shape
     * @return the same obstacle otherwise
     */
    public Obstacle withShape(ObstacleShape changed) {
        return new Obstacle(id, changed, pose, motion, specularAngle);
    }

    /**
     * This obstacle on another way.
     *
     * @param way its way-points, empty to stand still
     * @return the same obstacle otherwise
     */
    public Obstacle withMotion(Optional<WaypointPath> way) {
        return new Obstacle(id, shape, pose, way, specularAngle);
    }

    /**
     * This obstacle under another name.
     *
     * @param other unique in its world
     * @return the same obstacle otherwise
     */
    public Obstacle withId(String other) {
        return new Obstacle(other, shape, pose, motion, specularAngle);
    }

    /**
     * This obstacle somewhere else.
     *
     * @param elsewhere the new pose
     * @return the same obstacle otherwise
     */
    public Obstacle withPose(Pose elsewhere) {
        return new Obstacle(id, shape, elsewhere, motion, specularAngle);
    }
}
