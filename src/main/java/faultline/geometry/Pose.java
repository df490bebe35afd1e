package faultline.geometry;

/**
 * Position and heading in the plane: the paper's q = [x, y, theta], eq. (2).
 *
 * @param x metres, to the right
 * @param y metres, up
 * @param heading radians, counter-clockwise from the x axis; any finite number, never normalised by itself
 */
public record Pose(double x, double y, double heading) {

    /** At the origin, heading along the x axis. */
    public static final Pose ORIGIN = new Pose(0, 0, 0);

    public Pose {
        if (!(Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(heading))) {
            throw new IllegalArgumentException("a pose must be finite: x " + x + ", y " + y + ", heading " + heading);
        }
    }

    /**
     * Where this pose stands.
     *
     * @return the position, metres
     */
    public Vector2 position() {
        return new Vector2(x, y);
    }

    /**
     * A point given in this pose's frame, in the frame that the pose is given in.
     *
     * @param local metres ahead (x) and to the left (y) of the pose
     * @return the same point in the outer frame
     */
    public Vector2 toParent(Vector2 local) {
        double cos = StrictMath.cos(heading);
        double sin = StrictMath.sin(heading);
        return new Vector2(x + cos * local.x() - sin * local.y(), y + sin * local.x() + cos * local.y());
    }

    /**
     * A point of the outer frame, in this pose's frame.
     *
     * @param outer metres
     * @return metres ahead (x) and to the left (y) of the pose
     */
    public Vector2 toLocal(Vector2 outer) {
        double cos = StrictMath.cos(heading);
        double sin = StrictMath.sin(heading);
        double dx = outer.x() - x;
        double dy = outer.y() - y;
        return new Vector2(cos * dx + sin * dy, cos * dy - sin * dx);
    }
}
