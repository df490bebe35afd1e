package faultline.geometry;

/**
 * A closed convex part of an obstacle's geometry in the world: a segment, a disc or a filled ellipse. Sensor readings
 * and contacts are computed from its nearest point.
 */
public sealed interface ConvexShape permits Segment, Disc, Ellipse {

    /** Returns the nearest point of this shape to a point: the point itself if this shape contains it. */
    Vector2 nearestTo(Vector2 point);

    /** Returns the distance from a point to this shape, metres, 0 if this shape contains the point. */
    double distanceTo(double x, double y);

    /** Returns the centre of a circle that encloses this shape; its radius is {@link #boundingRadius()}. */
    Vector2 centre();

    /** Returns the radius of a circle about {@link #centre()} that encloses this shape, metres, not negative. */
    double boundingRadius();

    /** Returns this shape translated by (dx, dy), metres. */
    ConvexShape translated(double dx, double dy);
}
