package faultline.geometry;

/**
 * A filled ellipse.
 *
 * @param cx the centre's x, metres
 * @param cy the centre's y, metres
 * @param rx the half axis along the heading, metres, positive
 * @param ry the half axis across the heading, metres, positive
 * @param cos the cosine of the heading
 * @param sin the sine of the heading
 */
public record Ellipse(double cx, double cy, double rx, double ry, double cos, double sin) implements ConvexShape {

    /**
     * The ellipse at a pose.
     *
     * @param pose its centre and the direction of the first half axis
     * @param rx the half axis along the heading, metres, positive
     * @param ry the half axis across the heading, metres, positive
     * @return the placed ellipse
     */
    public static Ellipse at(Pose pose, double rx, double ry) {
        return new Ellipse(pose.x(), pose.y(), rx, ry, StrictMath.cos(pose.heading()), StrictMath.sin(pose.heading()));
    }

    /**
     * A point of the world in the ellipse's own frame.
     *
     * @param point metres, in the world
     * @return metres along the first and the second half axis
     */
    public Vector2 toLocal(Vector2 point) {
        double dx = point.x() - cx;
        double dy = point.y() - cy;
        return new Vector2(cos * dx + sin * dy, cos * dy - sin * dx);
    }

    /**
     * A point of the ellipse's own frame in the world.
     *
     * @param local metres along the half axes
     * @return metres, in the world
     */
    public Vector2 toWorld(Vector2 local) {
        return new Vector2(cx + cos * local.x() - sin * local.y(), cy + sin * local.x() + cos * local.y());
    }

    @Override
    public Vector2 nearestTo(Vector2 point) {
        Vector2 local = toLocal(point);
        double u = local.x() / rx;
        double v = local.y() / ry;
        if (u * u + v * v <= 1) {
            return point;
        }
        return toWorld(EllipseClosestPoint.compute(rx, ry, local));
    }

    /**
     * The point of the ellipse farthest in a direction.
     *
     * @param direction any vector but zero
     * @return the supporting point, in the world
     */
    public Vector2 supportPoint(Vector2 direction) {
        double u = rx * (cos * direction.x() + sin * direction.y());
        double v = ry * (cos * direction.y() - sin * direction.x());
        double length = Math.sqrt(u * u + v * v);
        return toWorld(new Vector2(rx * u / length, ry * v / length));
    }

    @Override
    public Vector2 centre() {
        return new Vector2(cx, cy);
    }

    @Override
    public double boundingRadius() {
        return Math.max(rx, ry);
    }

    @Override
    public Ellipse translated(double dx, double dy) {
        return new Ellipse(cx + dx, cy + dy, rx, ry, cos, sin);
    }
}
