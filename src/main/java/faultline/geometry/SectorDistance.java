package faultline.geometry;

/**
 * The distance from a sector's apex to the nearest point of a shape inside the sector: the reading of an ideal infrared
 * cone sensor. It is computed in closed form, up to rounding of the last digits; only the closest point of an ellipse
 * is found by iteration, to the last bit.
 *
 * <p>All shapes are convex. Seen from an apex outside a shape, the distance along its near side therefore decreases up
 * to the point closest to the apex and increases beyond it, so the nearest point in the cone is that closest point or
 * lies on an edge of the cone.
 *
 * <p>An instance is a sector that moves with a robot: plain numbers without checks, for the inner loop of a simulation.
 * Instances belong to one thread.
 */
public final class SectorDistance {

    private static final double NONE = Double.POSITIVE_INFINITY;

    /**
     * If both ends of a segment are farther beside an edge than this, metres, the segment is outside and does not go
     * through the apex, in spite of rounding. A point whose share along the axis, times twice the cosine of half the
     * angle, is below it, is behind the apex.
     */
    private static final double OUTSIDE = -1e-6;

    private final double cosHalf;
    private final double sinHalf;
    private final double range;
    // The apex, and the unit vectors along the left and the right edge.
    private double x;
    private double y;
    private double leftX;
    private double leftY;
    private double rightX;
    private double rightY;

    /**
     * Creates a sector at the origin, about the x axis.
     *
     * @param cosHalf the cosine of half the full angle, in (0, 1]
     * @param sinHalf the sine of half the full angle, in [0, 1)
     * @param range the radius, metres, positive
     */
    public SectorDistance(double cosHalf, double sinHalf, double range) {
        this.cosHalf = cosHalf;
        this.sinHalf = sinHalf;
        this.range = range;
        moveTo(0, 0, 1, 0);
    }

    /**
     * Creates a movable copy of a sector.
     *
     * @param sector the sector to copy
     */
    public SectorDistance(Sector sector) {
        this(sector.cosHalf(), sector.sinHalf(), sector.range());
        moveTo(
                sector.frame().x(),
                sector.frame().y(),
                sector.frame().cos(),
                sector.frame().sin());
    }

    /**
     * {@return the distance to a shape within a sector, metres in [0, range]; positive infinity if none of it is
     * inside}
     *
     * @param sector the sector; its edges and its arc belong to it
     * @param shape the shape; its inside belongs to it, so that an apex inside it is at distance 0
     */
    public static double nearest(Sector sector, ConvexShape shape) {
        return new SectorDistance(sector).nearest(shape);
    }

    /**
     * Moves the sector.
     *
     * @param apexX metres
     * @param apexY metres
     * @param axisX the cosine of the axis' direction
     * @param axisY the sine of the axis' direction
     */
    public void moveTo(double apexX, double apexY, double axisX, double axisY) {
        x = apexX;
        y = apexY;
        leftX = axisX * cosHalf - axisY * sinHalf;
        leftY = axisY * cosHalf + axisX * sinHalf;
        rightX = axisX * cosHalf + axisY * sinHalf;
        rightY = axisY * cosHalf - axisX * sinHalf;
    }

    /** {@return the radius, metres} */
    public double range() {
        return range;
    }

    /** Returns the apex' x, metres. */
    double x() {
        return x;
    }

    /** Returns the apex' y, metres. */
    double y() {
        return y;
    }

    /**
     * {@return the distance to a shape as {@link #nearest(Sector, ConvexShape)} does}
     *
     * @param shape the shape, in the parent frame
     */
    public double nearest(ConvexShape shape) {
        if (shape instanceof Segment segment) {
            return toSegment(segment.ax(), segment.ay(), segment.bx() - segment.ax(), segment.by() - segment.ay());
        }
        double distance = shape instanceof Disc disc ? toDisc(disc) : toEllipse((Ellipse) shape);
        return distance <= range ? distance : NONE;
    }

    /**
     * {@return the distance to the segment from (ax, ay) to (ax + dx, ay + dy)} The segment is clipped to the cone's
     * two half planes; the nearest point of the rest is the point closest to the apex or an end.
     *
     * @param ax the x coordinate of the first end, in metres
     * @param ay the y coordinate of the first end, in metres
     * @param dx the x component of the segment, in metres
     * @param dy the y component of the segment, in metres
     */
    public double toSegment(double ax, double ay, double dx, double dy) {
        double px = ax - x;
        double py = ay - y;
        // Signed distances of the ends from the lines of the edges, positive inside the cone: p x L and R x p.
        double leftStart = px * leftY - py * leftX;
        double leftGain = dx * leftY - dy * leftX;
        double rightStart = rightX * py - rightY * px;
        double rightGain = rightX * dy - rightY * dx;
        if (Math.max(leftStart, leftStart + leftGain) < OUTSIDE
                || Math.max(rightStart, rightStart + rightGain) < OUTSIDE) {
            return NONE;
        }
        double dd = dx * dx + dy * dy;
        double foot = dd == 0 ? 0 : Math.max(0, Math.min(1, -(px * dx + py * dy) / dd));
        double fx = px + foot * dx;
        double fy = py + foot * dy;
        double nearest = fx * fx + fy * fy;
        if (nearest > range * range) {
            return NONE;
        }
        if (nearest == 0) {
            return 0;
        }
        double from = Math.max(clipFrom(leftStart, leftGain), clipFrom(rightStart, rightGain));
        double to = Math.min(clipTo(leftStart, leftGain), clipTo(rightStart, rightGain));
        if (!(from <= to)) {
            return NONE;
        }
        double fraction = Math.max(from, Math.min(to, foot));
        double qx = px + fraction * dx;
        double qy = py + fraction * dy;
        if (isBehind(qx, qy)) {
            return NONE;
        }
        double distance = Math.sqrt(qx * qx + qy * qy);
        return distance <= range ? distance : NONE;
    }

    /** Returns the fraction in [0, 1] from which start + fraction * gain is not negative; above 1 if it never is. */
    private static double clipFrom(double start, double gain) {
        if (start >= 0) {
            return 0;
        }
        return start + gain < 0 ? NONE : Math.min(1, start / -gain);
    }

    /** Returns the fraction in [0, 1] up to which start + fraction * gain is not negative; below 0 if it never is. */
    private static double clipTo(double start, double gain) {
        if (start + gain >= 0) {
            return 1;
        }
        return start < 0 ? -NONE : Math.max(0, start / -gain);
    }

    private double toDisc(Disc disc) {
        double cx = disc.cx() - x;
        double cy = disc.cy() - y;
        double centre = Math.sqrt(cx * cx + cy * cy);
        double distance = centre - disc.radius();
        if (distance <= 0) {
            return 0;
        }
        if (distance > range) {
            return NONE;
        }
        if (containsDirection(cx, cy)) {
            return distance;
        }
        double power = distance * (centre + disc.radius());
        return Math.min(
                rayToCircle(leftX * cx + leftY * cy, leftX * cy - leftY * cx, disc.radius(), power),
                rayToCircle(rightX * cx + rightY * cy, rightX * cy - rightY * cx, disc.radius(), power));
    }

    /**
     * Returns the distance along a ray to a circle.
     *
     * @param along the centre's distance along the ray
     * @param aside the centre's distance from the ray's line
     * @param power the power of the apex with respect to the circle: |centre|^2 - radius^2, positive
     */
    private static double rayToCircle(double along, double aside, double radius, double power) {
        double chord = (radius - aside) * (radius + aside);
        return along > 0 && chord >= 0 ? power / (along + Math.sqrt(chord)) : NONE;
    }

    private double toEllipse(Ellipse ellipse) {
        RigidMotion frame = ellipse.frame();
        double dx = x - frame.x();
        double dy = y - frame.y();
        double limit = range + ellipse.boundingRadius();
        if (dx * dx + dy * dy > limit * limit) {
            return NONE;
        }
        double localX = frame.cos() * dx + frame.sin() * dy;
        double localY = frame.cos() * dy - frame.sin() * dx;
        double u = localX / ellipse.rx();
        double v = localY / ellipse.ry();
        if (u * u + v * v <= 1) {
            return 0;
        }
        double root = EllipseClosestPoint.root(ellipse.rx(), ellipse.ry(), localX, localY);
        double fx = EllipseClosestPoint.coordinate(ellipse.rx(), root, localX) - localX;
        double fy = EllipseClosestPoint.coordinate(ellipse.ry(), root, localY) - localY;
        if (containsDirection(frame.cos() * fx - frame.sin() * fy, frame.sin() * fx + frame.cos() * fy)) {
            return Math.sqrt(fx * fx + fy * fy);
        }
        return Math.min(rayToEllipse(ellipse, u, v, leftX, leftY), rayToEllipse(ellipse, u, v, rightX, rightY));
    }

    /** Returns the distance along a ray to an ellipse, in coordinates in which it is the unit circle: apex (u, v). */
    private static double rayToEllipse(Ellipse ellipse, double u, double v, double edgeX, double edgeY) {
        RigidMotion frame = ellipse.frame();
        double dx = (frame.cos() * edgeX + frame.sin() * edgeY) / ellipse.rx();
        double dy = (frame.cos() * edgeY - frame.sin() * edgeX) / ellipse.ry();
        double aside = u * dy - v * dx;
        double chord = dx * dx + dy * dy - aside * aside;
        double along = -(u * dx + v * dy);
        return along > 0 && chord >= 0 ? (u * u + v * v - 1) / (along + Math.sqrt(chord)) : NONE;
    }

    private boolean containsDirection(double dx, double dy) {
        return dx * leftY - dy * leftX >= 0 && rightX * dy - rightY * dx >= 0 && !isBehind(dx, dy);
    }

    /**
     * Returns whether a point is behind the apex, in spite of rounding. The edges of a very narrow cone are one line up
     * to rounding, of which half is behind the apex.
     */
    private boolean isBehind(double dx, double dy) {
        return dx * (leftX + rightX) + dy * (leftY + rightY) < OUTSIDE;
    }
}
