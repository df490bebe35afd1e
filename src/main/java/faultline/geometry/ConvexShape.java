package faultline.geometry;

/**
 * A closed convex piece that outlines are made of: a segment, a disc or a filled ellipse, placed in the world. Whatever
 * the robot senses or strikes is the nearest point of one of these.
 */
public sealed interface ConvexShape permits Segment, Disc, Ellipse {

    /**
     * The point of this figure nearest to another point.
     *
     * @param point any point
     * @return the nearest point; {@code point} itself where this figure contains it
     */
    Vector2 nearestTo(Vector2 point);

    /**
     * A point that, with {@link #boundingRadius()}, encloses the figure.
     *
     * @return the centre of the enclosing circle
     */
    Vector2 centre();

    /**
     * The radius of the enclosing circle about {@link #centre()}.
     *
     * @return metres, not negative
     */
    double boundingRadius();

    /**
     * This figure moved without turning.
     *
     * @param dx metres
     * @param dy metres
     * @return the moved figure
     */
    ConvexShape translated(double dx, double dy);
}
