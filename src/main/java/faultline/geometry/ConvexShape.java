package faultline.geometry;

/**
 * A closed convex part of an obstacle's geometry in the world: a segment, a disc or a filled ellipse. Sensor readings
 * and contacts are computed from its nearest point.
 */
public sealed interface ConvexShape permits Segment, Disc, Ellipse {

    /**
     * {@return the nearest point of this shape to a point: the point itself if this shape contains it}
     *
     * @param point the point, in the shape's frame
     */
    Vector2 nearestTo(Vector2 point);

    /**
     * {@return the distance from a point to this shape, metres, 0 if this shape contains the point}
     *
     * @param x the x coordinate of the point, in metres
     * @param y the y coordinate of the point, in metres
     */
    double distanceTo(double x, double y);

    /** {@return the centre of a circle that encloses this shape; its radius is {@link #boundingRadius()}} */
    Vector2 centre();

    /** {@return the radius of a circle about {@link #centre()} that encloses this shape, metres, not negative} */
    double boundingRadius();

    /**
     * {@return this shape translated by (dx, dy), metres}
     *
     * @param dx the translation along x, in metres
     * @param dy the translation along y, in metres
     */
    ConvexShape translated(double dx, double dy);
}
