package faultline.geometry;

/**
 * A filled circle.
 *
 * @param cx the centre's x, metres
 * @param cy the centre's y, metres
 * @param radius metres, not negative
 */
public record Disc(double cx, double cy, double radius) implements ConvexShape {

    @Override
    public Vector2 nearestTo(Vector2 point) {
        double dx = point.x() - cx;
        double dy = point.y() - cy;
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance <= radius) {
            return point;
        }
        return new Vector2(cx + dx / distance * radius, cy + dy / distance * radius);
    }

    @Override
    public Vector2 centre() {
        return new Vector2(cx, cy);
    }

    @Override
    public double boundingRadius() {
        return radius;
    }

    @Override
    public Disc translated(double dx, double dy) {
        return new Disc(cx + dx, cy + dy, radius);
    }
}
