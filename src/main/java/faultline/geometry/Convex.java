package faultline.geometry;

/**
 * A closed convex piece that outlines are made of: a segment, a disc or a filled ellipse, placed in the world.
 * Whatever the robot senses or strikes is the nearest point of one of these.
 */
public sealed interface Convex permits Segment, Disc, Oval {

    /**
     * The point of this figure nearest to another point.
     *
     * @param point any point
     * @return the nearest point; {@code point} itself where this figure contains it
     */
    Vec nearestTo(Vec point);

    /**
     * A point that, with {@link #reach()}, encloses the figure.
     *
     * @return the centre of the enclosing circle
     */
    Vec centre();

    /**
     * The radius of the enclosing circle about {@link #centre()}.
     *
     * @return metres, not negative
     */
    double reach();

    /**
     * This figure moved without turning.
     *
     * @param dx metres
     * @param dy metres
     * @return the moved figure
     */
    Convex shifted(double dx, double dy);
}
