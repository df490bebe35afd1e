package faultline.geometry;

/**
 * The nearest point of an ellipse to a point outside it, in the ellipse's own frame.
 *
 * <p>With the point folded into the first quadrant, the foot is (rx^2 u / (t + rx^2), ry^2 v / (t + ry^2)) where t is
 * the one root in t &gt; -min(rx, ry)^2 of the strictly falling F(t) = (rx u / (t + rx^2))^2 + (ry v / (t + ry^2))^2 -
 * 1 (D. Eberly, "Distance from a point to an ellipse"). Bisection is finished by bracketing to neighbouring numbers, so
 * that the foot is as exact as its formula.
 */
final class EllipseClosestPoint {

    private static final int MAX_STEPS = 200;

    private EllipseClosestPoint() {}

    /**
     * The foot of a point outside the ellipse or on it.
     *
     * @param rx the half axis along x, metres, positive
     * @param ry the half axis along y, metres, positive
     * @param p the point in the ellipse's frame
     * @return the nearest point of the ellipse
     */
    static Vector2 compute(double rx, double ry, Vector2 p) {
        double u = Math.abs(p.x());
        double v = Math.abs(p.y());
        // Scaled by the smaller half axis, F is the same for every size of ellipse.
        double m = Math.min(rx, ry);
        double root = root(rx / m, ry / m, u / m, v / m) * m * m;
        double x = rx * rx * u / (root + rx * rx);
        double y = ry * ry * v / (root + ry * ry);
        return new Vector2(Math.copySign(x, p.x()), Math.copySign(y, p.y()));
    }

    /**
     * The root t of F, which is not negative for a point outside: F(0) >= 0, and F falls. Newton from the left stays
     * left of it.
     */
    private static double root(double a, double b, double u, double v) {
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
