package faultline.geometry;

import java.util.function.Consumer;

/**
 * A straight wall without thickness. Its ends belong to it and may coincide.
 *
 * @param ax the first end's x, metres
 * @param ay the first end's y, metres
 * @param bx the second end's x, metres
 * @param by the second end's y, metres
 */
public record Segment(double ax, double ay, double bx, double by) implements ConvexShape {

    /**
     * Creates a segment.
     *
     * @param ax the first end's x, metres
     * @param ay the first end's y, metres
     * @param bx the second end's x, metres
     * @param by the second end's y, metres
     * @throws IllegalArgumentException if a coordinate is not finite
     */
    public Segment {
        if (!(Double.isFinite(ax) && Double.isFinite(ay) && Double.isFinite(bx) && Double.isFinite(by))) {
            throw new IllegalArgumentException(
                    "the ends of a segment must be finite: " + ax + ", " + ay + ", " + bx + ", " + by);
        }
    }

    /**
     * Creates the segment between two points.
     *
     * @param a the first end, in metres
     * @param b the second end, in metres
     * @throws IllegalArgumentException if a coordinate is not finite
     */
    public Segment(Vector2 a, Vector2 b) {
        this(a.x(), a.y(), b.x(), b.y());
    }

    /** {@return the first end} */
    public Vector2 a() {
        return new Vector2(ax, ay);
    }

    /** {@return the second end} */
    public Vector2 b() {
        return new Vector2(bx, by);
    }

    /** {@return the length, metres, 0 if the ends coincide} */
    public double length() {
        return a().distanceTo(b());
    }

    /**
     * {@return the point at a fraction of the segment, 0 for the first end and 1 for the second}
     *
     * @param fraction the fraction, not limited to [0, 1]
     */
    public Vector2 pointAt(double fraction) {
        return fraction == 1 ? b() : new Vector2(ax + fraction * (bx - ax), ay + fraction * (by - ay));
    }

    /**
     * Calls an action for evenly spaced points of the segment, the second end last; the first end is left out.
     *
     * @param step the greatest distance between two of them, metres; positive
     * @param action the action
     */
    public void forEachPoint(double step, Consumer<Vector2> action) {
        double count = Math.max(1, Math.ceil(length() / step));
        for (int i = 1; i <= count; i++) {
            action.accept(pointAt(i / count));
        }
    }

    @Override
    public Vector2 nearestTo(Vector2 point) {
        double dx = bx - ax;
        double dy = by - ay;
        double dd = dx * dx + dy * dy;
        if (dd == 0) {
            return a();
        }
        double fraction = ((point.x() - ax) * dx + (point.y() - ay) * dy) / dd;
        return pointAt(Math.max(0, Math.min(1, fraction)));
    }

    @Override
    public double distanceTo(double x, double y) {
        double dx = bx - ax;
        double dy = by - ay;
        double px = ax - x;
        double py = ay - y;
        double dd = dx * dx + dy * dy;
        double fraction = dd == 0 ? 0 : Math.max(0, Math.min(1, -(px * dx + py * dy) / dd));
        double fx = px + fraction * dx;
        double fy = py + fraction * dy;
        return Math.sqrt(fx * fx + fy * fy);
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
