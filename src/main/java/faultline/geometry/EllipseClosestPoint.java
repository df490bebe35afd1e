package faultline.geometry;

/**
 * The closest point of an ellipse to a point outside it, in the ellipse's own frame.
 *
 * <p>With the point (u, v) reflected into the first quadrant, the closest point is (rx^2 u / (t + rx^2), ry^2 v / (t +
 * ry^2)), where t is the only root in t &gt; -min(rx, ry)^2 of the strictly decreasing F(t) = (rx u / (t + rx^2))^2 +
 * (ry v / (t + ry^2))^2 - 1 (D. Eberly, "Distance from a point to an ellipse"). Newton's method with a bracket ends at
 * neighbouring numbers, so that the result is as exact as the formula.
 */
final class EllipseClosestPoint {

    private static final int MAX_STEPS = 200;

    private EllipseClosestPoint() {}

    /**
     * Returns the closest point of an ellipse to a point outside it or on it.
     *
     * @param rx the half axis along x, metres, positive
     * @param ry the half axis along y, metres, positive
     * @param p the point in the ellipse's frame
     */
    static Vector2 compute(double rx, double ry, Vector2 p) {
        double root = root(rx, ry, p.x(), p.y());
        return new Vector2(coordinate(rx, root, p.x()), coordinate(ry, root, p.y()));
    }

    /** Returns one coordinate of the closest point, from the half axis, the root t and the point's coordinate. */
    static double coordinate(double r, double root, double p) {
        return Math.copySign(r * r * Math.abs(p) / (root + r * r), p);
    }

    /** Returns the root t of F for a point (x, y) outside the ellipse or on it. */
    static double root(double rx, double ry, double x, double y) {
        // Scaled by the smaller half axis, F is the same for every size of ellipse.
        double m = Math.min(rx, ry);
        return scaledRoot(rx / m, ry / m, Math.abs(x) / m, Math.abs(y) / m) * m * m;
    }

    /**
     * For a point outside, F(0) >= 0, and F decreases: the root is not negative, and Newton's steps from 0 stay below.
     */
    private static double scaledRoot(double a, double b, double u, double v) {
        double low = 0;
        double high = Math.sqrt(a * a * u * u + b * b * v * v);
        double t = 0;
        for (int step = 0; step < MAX_STEPS; step++) {
            double p = a * u / (t + a * a);
            double q = b * v / (t + b * b);
            double value = p * p + q * q - 1;
            if (value == 0) {
                return t;
            }
            if (value > 0) {
                low = t;
            } else {
                high = t;
            }
            double slope = -2 * (p * p / (t + a * a) + q * q / (t + b * b));
            double next = t - value / slope;
            if (!(next > low && next < high)) {
                next = low + (high - low) / 2;
            }
            if (next == t || next <= low || next >= high) {
                return t;
            }
            t = next;
        }
        return t;
    }
}
