package faultline.geometry;

/**
 * A rectangle about the origin of a frame: the robot's body.
 *
 * @param frame the frame, with its x axis along the heading
 * @param halfLength half the side along the heading, metres, positive
 * @param halfWidth half the side across the heading, metres, positive
 */
public record OrientedBox(RigidMotion frame, double halfLength, double halfWidth) {

    /** The number of corners. */
    public static final int CORNERS = 4;

    /**
     * Creates a box.
     *
     * @param frame the frame, with its x axis along the heading
     * @param halfLength half the side along the heading, metres, positive
     * @param halfWidth half the side across the heading, metres, positive
     * @throws IllegalArgumentException if a half side is not positive and finite
     */
    public OrientedBox {
        if (!(halfLength > 0 && halfWidth > 0 && Double.isFinite(halfLength) && Double.isFinite(halfWidth))) {
            throw new IllegalArgumentException("the sides of a box must be positive: " + halfLength + ", " + halfWidth);
        }
    }

    /**
     * Creates a rectangle about a pose.
     *
     * @param pose its centre and heading
     * @param length the length of the side along the heading, metres, positive
     * @param width the width of the side across the heading, metres, positive
     * @throws IllegalArgumentException if a side is not positive and finite
     */
    public OrientedBox(Pose pose, double length, double width) {
        this(RigidMotion.of(pose), length / 2, width / 2);
    }

    /**
     * {@return a corner in the parent frame: 0 front left, 1 rear left, 2 rear right, 3 front right}
     *
     * @param index the index of the corner, 0 to 3
     */
    public Vector2 corner(int index) {
        return frame.toParent(
                new Vector2(index == 0 || index == 3 ? halfLength : -halfLength, index < 2 ? halfWidth : -halfWidth));
    }

    /** {@return the radius of the circle about the centre through the corners, metres} */
    public double boundingRadius() {
        return Math.sqrt(halfLength * halfLength + halfWidth * halfWidth);
    }

    /**
     * {@return the nearest point of the box: the point itself, up to rounding, if the box contains it}
     *
     * @param point the point, in the parent frame
     */
    public Vector2 nearestTo(Vector2 point) {
        return frame.toParent(clamp(frame.toLocal(point)));
    }

    /** Returns the nearest point of the box in its own frame: the point itself if the box contains it. */
    Vector2 clamp(Vector2 local) {
        return new Vector2(
                Math.max(-halfLength, Math.min(halfLength, local.x())),
                Math.max(-halfWidth, Math.min(halfWidth, local.y())));
    }
}
