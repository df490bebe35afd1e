package faultline.geometry;

/**
 * A filled circle.
 *
 * @param cx the centre's x, metres
 * @param cy the centre's y, metres
 * @param radius metres, not negative
 */
public record Disc(double cx, double cy, double radius) implements ConvexShape {

    /**
     * Creates a disc.
     *
     * @param cx the centre's x, metres
     * @param cy the centre's y, metres
     * @param radius metres, not negative
     * @throws IllegalArgumentException if the centre or the radius is not finite, or the radius is negative
     */
    public Disc {
        if (!(radius >= 0 && Double.isFinite(cx) && Double.isFinite(cy) && Double.isFinite(radius))) {
            throw new IllegalArgumentException("a disc needs a finite centre and a radius that is not negative: " + cx
                    + ", " + cy + ", " + radius);
        }
    }

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
    public double distanceTo(double x, double y) {
        double dx = x - cx;
        double dy = y - cy;
        return Math.max(0, Math.sqrt(dx * dx + dy * dy) - radius);
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

    /** {@return this disc as an ellipse with two equal half axes} */
    public Ellipse toEllipse() {
        return new Ellipse(new RigidMotion(1, 0, cx, cy), radius, radius);
    }
}
