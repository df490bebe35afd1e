package faultline.geometry;

/**
 * A filled circle.
 *
 * @param cx the centre's x, metres
 * @param cy the centre's y, metres
 * @param radius metres, not negative
 */
public record Disc(double cx, double cy, double radius) implements Convex {

    @Override
    public Vec nearestTo(Vec point) {
        double dx = point.x() - cx;
        double dy = point.y() - cy;
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance <= radius) {
            return point;
        }
        return new Vec(cx + dx / distance * radius, cy + dy / distance * radius);
    }

    @Override
    public Vec centre() {
        return new Vec(cx, cy);
    }

    @Override
    public double reach() {
        return radius;
    }

    @Override
    public Disc shifted(double dx, double dy) {
        return new Disc(cx + dx, cy + dy, radius);
    }
}
