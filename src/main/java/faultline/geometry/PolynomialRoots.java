package faultline.geometry;

import java.util.ArrayList;
import java.util.List;

/** Finds the real roots of a polynomial in an interval, each to the last bit between the roots of its derivative. */
final class PolynomialRoots {

    private PolynomialRoots() {}

    /**
     * Returns all roots in an interval at which the polynomial changes its sign, in ascending order. The first
     * coefficient is the constant term.
     */
    static List<Double> between(double[] coefficients, double low, double high) {
        List<Double> roots = new ArrayList<>();
        if (coefficients.length < 2) {
            return roots;
        }
        List<Double> bounds = between(derivative(coefficients), low, high);
        bounds.add(high);
        double from = low;
        for (double to : bounds) {
            addRoot(coefficients, from, to, roots);
            from = to;
        }
        return roots;
    }

    private static double[] derivative(double[] coefficients) {
        double[] result = new double[coefficients.length - 1];
        for (int i = 0; i < result.length; i++) {
            result[i] = (i + 1) * coefficients[i + 1];
        }
        return result;
    }

    /** Adds the root, if any, between two bounds; the polynomial is monotone there. */
    private static void addRoot(double[] coefficients, double from, double to, List<Double> roots) {
        boolean rising = value(coefficients, from) < 0;
        if (rising == value(coefficients, to) < 0) {
            return;
        }
        double low = from;
        double high = to;
        while (true) {
            double middle = low + (high - low) / 2;
            if (middle <= low || middle >= high) {
                roots.add(middle);
                return;
            }
            if (value(coefficients, middle) < 0 == rising) {
                low = middle;
            } else {
                high = middle;
            }
        }
    }

    private static double value(double[] coefficients, double x) {
        double sum = 0;
        for (int i = coefficients.length - 1; i >= 0; i--) {
            sum = sum * x + coefficients[i];
        }
        return sum;
    }
}
