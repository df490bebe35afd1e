package faultline.geometry;

/**
 * The distance from a sector's apex to the nearest point of a figure inside the sector: what an infrared cone sensor
 * reads. In closed form, up to the rounding of the last digits; only the foot on an ellipse is iterated, to the last
 * bit.
 *
 * <p>All figures are convex, so seen from an apex outside them the distance along their near side falls to the foot of
 * the apex and rises after it. The nearest point in the cone is therefore the foot, or else lies on an edge of the
 * cone.
 */
public final class SectorDistance {

    private static final double NONE = Double.POSITIVE_INFINITY;

    private SectorDistance() {}

    /**
     * The distance to a figure within a sector.
     *
     * @param sector the sector; its edges and its arc belong to it
     * @param figure the figure; its inside belongs to it, so that an apex inside it is at distance 0
     * @return metres in [0, range], or positive infinity where the sector holds no point of the figure
     */
    public static double nearest(Sector sector, ConvexShape figure) {
        double distance;
        if (figure instanceof Segment segment) {
            distance = toSegment(sector, segment);
        } else if (figure instanceof Disc disc) {
            distance = toDisc(sector, disc);
        } else {
            distance = toEllipse(sector, (Ellipse) figure);
        }
        return distance <= sector.range() ? distance : NONE;
    }

    /**
     * The segment is clipped to the cone's two half planes; the nearest point of what remains is the foot or an end.
     */
    private static double toSegment(Sector s, Segment segment) {
        double px = segment.ax() - s.ax();
        double py = segment.ay() - s.ay();
        double dx = segment.bx() - segment.ax();
        double dy = segment.by() - segment.ay();
        double dd = dx * dx + dy * dy;
        double foot = dd == 0 ? 0 : Math.max(0, Math.min(1, -(px * dx + py * dy) / dd));
        double fx = px + foot * dx;
        double fy = py + foot * dy;
        double nearest = fx * fx + fy * fy;
        if (nearest > s.range() * s.range()) {
            return NONE;
        }
        if (nearest == 0) {
            return 0;
        }
        // Signed distances of the ends from the edges' lines, positive inside the cone: p x L and R x p.
        double lx = s.ux() * s.cosHalf() - s.uy() * s.sinHalf();
        double ly = s.uy() * s.cosHalf() + s.ux() * s.sinHalf();
        double rx = s.ux() * s.cosHalf() + s.uy() * s.sinHalf();
        double ry = s.uy() * s.cosHalf() - s.ux() * s.sinHalf();
        double leftStart = px * ly - py * lx;
        double leftGain = dx * ly - dy * lx;
        double rightStart = rx * py - ry * px;
        double rightGain = rx * dy - ry * dx;
        double from = Math.max(clipFrom(leftStart, leftGain), clipFrom(rightStart, rightGain));
        double to = Math.min(clipTo(leftStart, leftGain), clipTo(rightStart, rightGain));
        if (!(from <= to)) {
            return NONE;
        }
        double share = Math.max(from, Math.min(to, foot));
        double qx = px + share * dx;
        double qy = py + share * dy;
        return Math.sqrt(qx * qx + qy * qy);
    }

    /** Where, in [0, 1], start + share * gain becomes not negative; above 1 where it never does. */
    private static double clipFrom(double start, double gain) {
        if (start >= 0) {
            return 0;
        }
        return start + gain < 0 ? NONE : Math.min(1, start / -gain);
    }

    /** Where, in [0, 1], start + share * gain stops being not negative; below 0 where it never is. */
    private static double clipTo(double start, double gain) {
        if (start + gain >= 0) {
            return 1;
        }
        return start < 0 ? -NONE : Math.max(0, start / -gain);
    }

    private static double toDisc(Sector s, Disc disc) {
        double cx = disc.cx() - s.ax();
        double cy = disc.cy() - s.ay();
        double centre = Math.sqrt(cx * cx + cy * cy);
        double distance = centre - disc.radius();
        if (distance <= 0) {
            return 0;
        }
        if (distance > s.range()) {
            return NONE;
        }
        if (containsDirection(s, cx, cy)) {
            return distance;
        }
        double power = distance * (centre + disc.radius());
        return Math.min(
                rayDistance(leftX(s) * cx + leftY(s) * cy, leftX(s) * cy - leftY(s) * cx, disc.radius(), power),
                rayDistance(rightX(s) * cx + rightY(s) * cy, rightX(s) * cy - rightY(s) * cx, disc.radius(), power));
    }

    /**
     * How far along a ray a circle begins.
     *
     * @param along the centre's distance along the ray
     * @param aside the centre's distance from the ray's line
     * @param power of the apex with regard to the circle: |centre|^2 - radius^2, positive
     */
    private static double rayDistance(double along, double aside, double radius, double power) {
        double chord = (radius - aside) * (radius + aside);
        return along > 0 && chord >= 0 ? power / (along + Math.sqrt(chord)) : NONE;
    }

    private static double toEllipse(Sector s, Ellipse oval) {
        double dx = s.ax() - oval.cx();
        double dy = s.ay() - oval.cy();
        double limit = s.range() + oval.boundingRadius();
        if (dx * dx + dy * dy > limit * limit) {
            return NONE;
        }
        Vector2 apex = oval.toLocal(s.apex());
        double u = apex.x() / oval.rx();
        double v = apex.y() / oval.ry();
        if (u * u + v * v <= 1) {
            return 0;
        }
        Vector2 foot = EllipseClosestPoint.compute(oval.rx(), oval.ry(), apex);
        double fx = foot.x() - apex.x();
        double fy = foot.y() - apex.y();
        if (containsDirection(s, oval.cos() * fx - oval.sin() * fy, oval.sin() * fx + oval.cos() * fy)) {
            return Math.sqrt(fx * fx + fy * fy);
        }
        return Math.min(rayDistance(oval, apex, leftX(s), leftY(s)), rayDistance(oval, apex, rightX(s), rightY(s)));
    }

    /** How far along a ray an ellipse begins: the axes are scaled until it is the unit circle. */
    private static double rayDistance(Ellipse oval, Vector2 apex, double ex, double ey) {
        double ax = apex.x() / oval.rx();
        double ay = apex.y() / oval.ry();
        double dx = (oval.cos() * ex + oval.sin() * ey) / oval.rx();
        double dy = (oval.cos() * ey - oval.sin() * ex) / oval.ry();
        double aside = ax * dy - ay * dx;
        double chord = dx * dx + dy * dy - aside * aside;
        double along = -(ax * dx + ay * dy);
        return along > 0 && chord >= 0 ? (ax * ax + ay * ay - 1) / (along + Math.sqrt(chord)) : NONE;
    }

    /** Whether a direction lies in the cone. */
    private static boolean containsDirection(Sector s, double x, double y) {
        return x * leftY(s) - y * leftX(s) >= 0 && rightX(s) * y - rightY(s) * x >= 0;
    }

    private static double leftX(Sector s) {
        return s.ux() * s.cosHalf() - s.uy() * s.sinHalf();
    }

    private static double leftY(Sector s) {
        return s.uy() * s.cosHalf() + s.ux() * s.sinHalf();
    }

    private static double rightX(Sector s) {
        return s.ux() * s.cosHalf() + s.uy() * s.sinHalf();
    }

    private static double rightY(Sector s) {
        return s.uy() * s.cosHalf() - s.ux() * s.sinHalf();
    }
}
