package faultline.geometry;

/**
 * Position and heading in the plane: the paper's q = [x, y, theta], eq. (2).
 *
 * @param x metres, to the right
 * @param y metres, up
 * @param heading radians, counter-clockwise from the x axis; any finite number, not normalised
 */
public record Pose(double x, double y, double heading) {

    /** The origin, with heading along the x axis. */
    public static final Pose ORIGIN = new Pose(0, 0, 0);

    /**
     * Creates a pose.
     *
     * @param x metres, to the right
     * @param y metres, up
     * @param heading radians, counter-clockwise from the x axis; any finite number, not normalised
     * @throws IllegalArgumentException if a coordinate or the heading is not finite
     */
    public Pose {
        if (!(Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(heading))) {
            throw new IllegalArgumentException("a pose must be finite: x " + x + ", y " + y + ", heading " + heading);
        }
    }

    /** {@return the position, metres} */
    public Vector2 position() {
        return new Vector2(x, y);
    }

    /**
     * {@return the pose at another position with the same heading}
     *
     * @param position the new position, in metres
     */
    public Pose withPosition(Vector2 position) {
        return new Pose(position.x(), position.y(), heading);
    }

    /**
     * {@return a point of this pose's frame, metres ahead (x) and to the left (y), in the parent frame}
     *
     * @param local the point in this pose's frame, in metres
     */
    public Vector2 toParent(Vector2 local) {
        return RigidMotion.of(this).toParent(local);
    }

    /**
     * {@return a point of the parent frame in this pose's frame, metres ahead (x) and to the left (y)}
     *
     * @param parent the point in the parent frame, in metres
     */
    public Vector2 toLocal(Vector2 parent) {
        return RigidMotion.of(this).toLocal(parent);
    }
}
