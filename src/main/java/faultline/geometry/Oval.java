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
public record Oval(double cx, double cy, double rx, double ry, double cos, double sin) implements Convex {

    /**
     * The ellipse at a pose.
     *
     * @param pose its centre and the direction of the first half axis
     * @param rx the half axis along the heading, metres, positive
     * @param ry the half axis across the heading, metres, positive
     * @return the placed ellipse
     */
    public static Oval at(Pose pose, double rx, double ry) {
        return new Oval(pose.x(), pose.y(), rx, ry, StrictMath.cos(pose.heading()), StrictMath.sin(pose.heading()));
    }

    /**
     * A point of the world in the ellipse's own frame.
     *
     * @param point metres, in the world
     * @return metres along the first and the second half axis
     */
    public Vec toLocal(Vec point) {
        double dx = point.x() - cx;
        double dy = point.y() - cy;
        return new Vec(cos * dx + sin * dy, cos * dy - sin * dx);
    }

    /**
     * A point of the ellipse's own frame in the world.
     *
     * @param local metres along the half axes
     * @return metres, in the world
     */
    public Vec toWorld(Vec local) {
        return new Vec(cx + cos * local.x() - sin * local.y(), cy + sin * local.x() + cos * local.y());
    }

    @Override
    public Vec nearestTo(Vec point) {
        Vec local = toLocal(point);
        double u = local.x() / rx;
        double v = local.y() / ry;
        if (u * u + v * v <= 1) {
            return point;
        }
        return toWorld(EllipseFoot.of(rx, ry, local));
    }

    /**
     * The point of the ellipse farthest in a direction.
     *
     * @param direction any vector but zero
     * @return the supporting point, in the world
     */
    public Vec support(Vec direction) {
        double u = rx * (cos * direction.x() + sin * direction.y());
        double v = ry * (cos * direction.y() - sin * direction.x());
        double length = Math.sqrt(u * u + v * v);
        return toWorld(new Vec(rx * u / length, ry * v / length));
    }

    @Override
    public Vec centre() {
        return new Vec(cx, cy);
    }

    @Override
    public double reach() {
        return Math.max(rx, ry);
    }

    @Override
    public Oval shifted(double dx, double dy) {
        return new Oval(cx + dx, cy + dy, rx, ry, cos, sin);
    }
}
