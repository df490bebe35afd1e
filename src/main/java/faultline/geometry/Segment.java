package faultline.geometry;

/**
 * A straight piece of wall without thickness; its ends belong to it and may coincide.
 *
 * @param ax the first end's x, metres
 * @param ay the first end's y, metres
 * @param bx the second end's x, metres
 * @param by the second end's y, metres
 */
public record Segment(double ax, double ay, double bx, double by) implements Convex {

    /**
     * The segment between two points.
     *
     * @param a the first end
     * @param b the second end
     */
    public Segment(Vec a, Vec b) {
        this(a.x(), a.y(), b.x(), b.y());
    }

    /**
     * The first end.
     *
     * @return metres
     */
    public Vec a() {
        return new Vec(ax, ay);
    }

    /**
     * The second end.
     *
     * @return metres
     */
    public Vec b() {
        return new Vec(bx, by);
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
    public Vec at(double share) {
        return share == 1 ? b() : new Vec(ax + share * (bx - ax), ay + share * (by - ay));
    }

    @Override
    public Vec nearestTo(Vec point) {
        double dx = bx - ax;
        double dy = by - ay;
        double dd = dx * dx + dy * dy;
        if (dd == 0) {
            return a();
        }
        double share = ((point.x() - ax) * dx + (point.y() - ay) * dy) / dd;
        return at(Math.max(0, Math.min(1, share)));
    }

    @Override
    public Vec centre() {
        return new Vec((ax + bx) / 2, (ay + by) / 2);
    }

    @Override
    public double reach() {
        return length() / 2;
    }

    @Override
    public Segment shifted(double dx, double dy) {
        return new Segment(ax + dx, ay + dy, bx + dx, by + dy);
    }
}
