package faultline.geometry;

/**
 * A rectangle about a pose: the robot's body.
 *
 * @param cx the centre's x, metres
 * @param cy the centre's y, metres
 * @param cos the cosine of the heading
 * @param sin the sine of the heading
 * @param halfLength half the side along the heading, metres, positive
 * @param halfWidth half the side across the heading, metres, positive
 */
public record OrientedBox(double cx, double cy, double cos, double sin, double halfLength, double halfWidth) {

    /**
     * The rectangle about a pose.
     *
     * @param pose its centre and heading
     * @param length of the side along the heading, metres, positive
     * @param width of the side across the heading, metres, positive
     */
    public OrientedBox(Pose pose, double length, double width) {
        this(pose.x(), pose.y(), StrictMath.cos(pose.heading()), StrictMath.sin(pose.heading()), length / 2, width / 2);
    }

    /**
     * A point of the world in the box's frame.
     *
     * @param point metres
     * @return metres along and across the heading
     */
    public Vector2 toLocal(Vector2 point) {
        double dx = point.x() - cx;
        double dy = point.y() - cy;
        return new Vector2(cos * dx + sin * dy, cos * dy - sin * dx);
    }

    /**
     * A point of the box's frame in the world.
     *
     * @param local metres along and across the heading
     * @return metres
     */
    public Vector2 toWorld(Vector2 local) {
        return new Vector2(cx + cos * local.x() - sin * local.y(), cy + sin * local.x() + cos * local.y());
    }

    /**
     * A corner in the box's frame.
     *
     * @param index 0 front left, 1 rear left, 2 rear right, 3 front right
     * @return metres along and across the heading
     */
    public Vector2 localCorner(int index) {
        return new Vector2(index == 0 || index == 3 ? halfLength : -halfLength, index < 2 ? halfWidth : -halfWidth);
    }

    /**
     * A corner in the world.
     *
     * @param index 0 front left, 1 rear left, 2 rear right, 3 front right
     * @return metres
     */
    public Vector2 corner(int index) {
        return toWorld(localCorner(index));
    }

    /**
     * The radius of the circle about the centre through the corners.
     *
     * @return metres
     */
    public double boundingRadius() {
        return Math.sqrt(halfLength * halfLength + halfWidth * halfWidth);
    }

    /**
     * The nearest point of the box.
     *
     * @param point any point of the world
     * @return the point itself where the box contains it, up to rounding
     */
    public Vector2 nearestTo(Vector2 point) {
        return toWorld(clamped(toLocal(point)));
    }

    /**
     * The nearest point of the box in its own frame.
     *
     * @param local a point of the box's frame
     * @return the point itself where the box contains it
     */
    Vector2 clamped(Vector2 local) {
        return new Vector2(
                Math.max(-halfLength, Math.min(halfLength, local.x())),
                Math.max(-halfWidth, Math.min(halfWidth, local.y())));
    }
}
