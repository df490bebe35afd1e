package faultline.geometry;

/**
 * A straight piece of wall without thickness; its ends belong to it and may coincide.
 *
 * @param ax the first end's x, metres
 * @param ay the first end's y, metres
 * @param bx the second end's x, metres
 * @param by the second end's y, metres
 */
public record Segment(double ax, double ay, double bx, double by) implements ConvexShape {

    /**
     * The segment between two points.
     *
     * @param a the first end
     * @param b the second end
     */
    public Segment(Vector2 a, Vector2 b) {
        this(a.x(), a.y(), b.x(), b.y());
    }

    /**
     * The first end.
     *
     * @return metres
     */
    public Vector2 a() {
        return new Vector2(ax, ay);
    }

    /**
     * The second end.
     *
     * @return metres
     */
    public Vector2 b() {
        return new Vector2(bx, by);
    }

    /**
     * The length.
     *
     * @return metres, 0 where the ends coincide
     */
    public double length() {
        return a().distanceTo(b());
    }

    /**
     * The point at a share of the way from the first end to the second.
     *
     * @param share 0 at the first end, 1 at the second
     * @return the point
     */
    public Vector2 pointAt(double share) {
        return share == 1 ? b() : new Vector2(ax + share * (bx - ax), ay + share * (by - ay));
    }

    @Override
    public Vector2 nearestTo(Vector2 point) {
        double dx = bx - ax;
        double dy = by - ay;
        double dd = dx * dx + dy * dy;
        if (dd == 0) {
            return a();
        }
        double share = ((point.x() - ax) * dx + (point.y() - ay) * dy) / dd;
        return pointAt(Math.max(0, Math.min(1, share)));
    }

    @Override
    public Vector2 centre() {
        return new Vector2((ax + bx) / 2, (ay + by) / 2);
    }

    @Override
    public double boundingRadius() {
        return length() / 2;
    }

    @Override
    public Segment translated(double dx, double dy) {
        return new Segment(ax + dx, ay + dy, bx + dx, by + dy);
    }
}
