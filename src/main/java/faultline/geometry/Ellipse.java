package faultline.geometry;

/**
 * A filled ellipse.
 *
 * @param frame the frame whose origin is the centre and whose axes carry the half axes
 * @param rx the half axis along the frame's x axis, metres, positive
 * @param ry the half axis along the frame's y axis, metres, positive
 */
public record Ellipse(RigidMotion frame, double rx, double ry) implements ConvexShape {

    /**
     * Creates an ellipse.
     *
     * @param frame the frame whose origin is the centre and whose axes carry the half axes
     * @param rx the half axis along the frame's x axis, metres, positive
     * @param ry the half axis along the frame's y axis, metres, positive
     * @throws IllegalArgumentException if a half axis is not positive and finite
     */
    public Ellipse {
        if (!(rx > 0 && ry > 0 && Double.isFinite(rx) && Double.isFinite(ry))) {
            throw new IllegalArgumentException("the half axes of an ellipse must be positive: " + rx + ", " + ry);
        }
    }

    @Override
    public Vector2 nearestTo(Vector2 point) {
        Vector2 local = frame.toLocal(point);
        double u = local.x() / rx;
        double v = local.y() / ry;
        if (u * u + v * v <= 1) {
            return point;
        }
        return frame.toParent(EllipseClosestPoint.compute(rx, ry, local));
    }

    @Override
    public double distanceTo(double x, double y) {
        double dx = x - frame.x();
        double dy = y - frame.y();
        double localX = frame.cos() * dx + frame.sin() * dy;
        double localY = frame.cos() * dy - frame.sin() * dx;
        double u = localX / rx;
        double v = localY / ry;
        if (u * u + v * v <= 1) {
            return 0;
        }
        double root = EllipseClosestPoint.root(rx, ry, localX, localY);
        double fx = EllipseClosestPoint.coordinate(rx, root, localX) - localX;
        double fy = EllipseClosestPoint.coordinate(ry, root, localY) - localY;
        return Math.sqrt(fx * fx + fy * fy);
    }

    /**
     * {@return the point of the ellipse farthest in a direction}
     *
     * @param direction any vector except zero
     */
    Vector2 supportPoint(Vector2 direction) {
        double u = rx * (frame.cos() * direction.x() + frame.sin() * direction.y());
        double v = ry * (frame.cos() * direction.y() - frame.sin() * direction.x());
        double length = Math.sqrt(u * u + v * v);
        return frame.toParent(new Vector2(rx * u / length, ry * v / length));
    }

    /** Returns a point of the parent frame in coordinates in which this ellipse is the unit circle. */
    Vector2 toUnitCircle(Vector2 point) {
        Vector2 local = frame.toLocal(point);
        return new Vector2(local.x() / rx, local.y() / ry);
    }

    @Override
    public Vector2 centre() {
        return frame.position();
    }

    @Override
    public double boundingRadius() {
        return Math.max(rx, ry);
    }

    @Override
    public Ellipse translated(double dx, double dy) {
        return new Ellipse(frame.translated(dx, dy), rx, ry);
    }
}
