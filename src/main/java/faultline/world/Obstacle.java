package faultline.world;

import faultline.geometry.Pose;
import java.util.Objects;

/**
 * An obstacle at one moment.
 *
 * @param id unique in its world
 * @param shape the shape in its own frame
 * @param pose the pose of that frame in the world
 * @param motion its path, {@link WaypointPath#NONE} for a static obstacle
 * @param specularAngle the greatest angle of incidence at which its surface reflects light back to a sensor, radians
 *     from the normal, in (0, pi / 2]; {@link #MATT} for all angles
 */
public record Obstacle(String id, ObstacleShape shape, Pose pose, WaypointPath motion, double specularAngle) {

    /** The specular angle of a matt surface, which is sensed at any angle. */
    public static final double MATT = StrictMath.PI / 2;

    /**
     * Creates an obstacle.
     *
     * @param id unique in its world
     * @param shape the shape in its own frame
     * @param pose the pose of that frame in the world
     * @param motion its path, {@link WaypointPath#NONE} for a static obstacle
     * @param specularAngle the greatest angle of incidence at which its surface reflects light back to a sensor,
     *     radians from the normal, in (0, pi / 2]; {@link #MATT} for all angles
     * @throws IllegalArgumentException if the id is empty, the specular angle is outside (0, pi / 2], or a surface that
     *     is not flat is specular
     */
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
        if (specularAngle < MATT && !shape.isFlat()) {
            throw new IllegalArgumentException("only flat surfaces can be specular: " + id);
        }
    }

    /**
     * Creates an obstacle with a matt surface.
     *
     * @param id the id, not empty
     * @param shape the shape
     * @param pose the pose at the start of the run
     * @param motion the path that it follows
     */
    public Obstacle(String id, ObstacleShape shape, Pose pose, WaypointPath motion) {
        this(id, shape, pose, motion, MATT);
    }

    /**
     * Creates a static obstacle with a matt surface.
     *
     * @param id the id, not empty
     * @param shape the shape
     * @param pose the pose
     */
    public Obstacle(String id, ObstacleShape shape, Pose pose) {
        this(id, shape, pose, WaypointPath.NONE);
    }

    /** {@return whether this obstacle follows waypoints, though perhaps at speed 0} */
    public boolean isMoving() {
        return !motion.waypoints().isEmpty();
    }

    /** {@return whether its surface reflects light back only at small angles of incidence} */
    public boolean isSpecular() {
        return specularAngle < MATT;
    }

    /**
     * {@return this obstacle with another shape}
     *
     * @param newShape the new shape
     */
    public Obstacle withShape(ObstacleShape newShape) {
        return new Obstacle(id, newShape, pose, motion, specularAngle);
    }

    /**
     * {@return this obstacle with another path}
     *
     * @param newMotion the new path
     */
    public Obstacle withMotion(WaypointPath newMotion) {
        return new Obstacle(id, shape, pose, newMotion, specularAngle);
    }

    /**
     * {@return this obstacle with another id}
     *
     * @param newId the new id, not empty
     */
    public Obstacle withId(String newId) {
        return new Obstacle(newId, shape, pose, motion, specularAngle);
    }

    /**
     * {@return this obstacle at another pose}
     *
     * @param newPose the new pose
     */
    public Obstacle withPose(Pose newPose) {
        return new Obstacle(id, shape, newPose, motion, specularAngle);
    }

    /**
     * {@return this obstacle with another specular angle, radians}
     *
     * @param newAngle the greatest angle of incidence that is reflected back, in radians, in (0, pi / 2]
     */
    public Obstacle withSpecularAngle(double newAngle) {
        return new Obstacle(id, shape, pose, motion, newAngle);
    }
}
