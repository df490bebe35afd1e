package faultline.world;

import faultline.geometry.Pose;
import java.util.Objects;

/**
 * An obstacle at one moment.
 *
 * @param id unique in its world
 * @param shape in its own frame
 * @param pose of that frame in the world
 * @param motion its path, {@link WaypointPath#NONE} for a static obstacle
 * @param specularAngle the greatest angle of incidence at which its surface reflects light back to a sensor, radians
 *     from the normal, in (0, pi / 2]; {@link #MATT} for all angles
 */
public record Obstacle(String id, ObstacleShape shape, Pose pose, WaypointPath motion, double specularAngle) {

    /** The specular angle of a matt surface, which is sensed at any angle. */
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
        if (specularAngle < MATT && !shape.isFlat()) {
            throw new IllegalArgumentException("only flat surfaces can be specular: " + id);
        }
    }

    /** Creates an obstacle with a matt surface. */
    public Obstacle(String id, ObstacleShape shape, Pose pose, WaypointPath motion) {
        this(id, shape, pose, motion, MATT);
    }

    /** Creates a static obstacle with a matt surface. */
    public Obstacle(String id, ObstacleShape shape, Pose pose) {
        this(id, shape, pose, WaypointPath.NONE);
    }

    /** Returns whether this obstacle follows way-points, though perhaps at speed 0. */
    public boolean isMoving() {
        return !motion.waypoints().isEmpty();
    }

    /** Returns whether its surface reflects light back only at small angles of incidence. */
    public boolean isSpecular() {
        return specularAngle < MATT;
    }

    /** Returns this obstacle with another shape. */
    public Obstacle withShape(ObstacleShape newShape) {
        return new Obstacle(id, newShape, pose, motion, specularAngle);
    }

    /** Returns this obstacle with another path. */
    public Obstacle withMotion(WaypointPath newMotion) {
        return new Obstacle(id, shape, pose, newMotion, specularAngle);
    }

    /** Returns this obstacle with another id. */
    public Obstacle withId(String newId) {
        return new Obstacle(newId, shape, pose, motion, specularAngle);
    }

    /** Returns this obstacle at another pose. */
    public Obstacle withPose(Pose newPose) {
        return new Obstacle(id, shape, newPose, motion, specularAngle);
    }

    /** Returns this obstacle with another specular angle, radians. */
    public Obstacle withSpecularAngle(double newAngle) {
        return new Obstacle(id, shape, pose, motion, newAngle);
    }
}
