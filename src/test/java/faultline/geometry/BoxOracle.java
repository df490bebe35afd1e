package faultline.geometry;

import java.util.function.DoubleUnaryOperator;

/**
 * An independent judge of the distance between a box and a convex figure: how far a point lies outside a box is a convex function of the point, and its
 * least value over a convex figure is found by ternary search, nested for a figure with an inside.
 */
final class BoxOracle {

    private static final int STEPS = 90;

    private BoxOracle() {
    }

    /** The distance, metres, 0 where they overlap. */
    static double distance(Box box, Convex figure) {
        if (figure instanceof Segment segment) {
            return least(share -> outside(box, segment.at(share)), 0, 1);
        }
        if (figure instanceof Oval oval) {
            return least(u -> leastAcross(box, oval, u), -1, 1);
        }
        return Math.max(0, outside(box, figure.centre()) - figure.reach());
    }

    /** How far a point lies outside a box, metres, 0 inside. */
    static double outside(Box box, Vec point) {
        double dx = point.x() - box.cx();
        double dy = point.y() - box.cy();
        double ahead = Math.abs(box.cos() * dx + box.sin() * dy) - box.halfLength();
        double aside = Math.abs(box.cos() * dy - box.sin() * dx) - box.halfWidth();
        return Math.hypot(Math.max(0, ahead), Math.max(0, aside));
    }

    /** How far a point lies outside a figure, metres, 0 inside; for an ellipse a bound from its level, good on its outline. */
    static double outside(Convex figure, Vec point) {
        if (figure instanceof Segment segment) {
            return least(share -> point.distanceTo(segment.at(share)), 0, 1);
        }
        if (figure instanceof Oval oval) {
            Vec local = oval.toLocal(point);
            double level = Math.hypot(local.x() / oval.rx(), local.y() / oval.ry());
            return Math.max(0, (level - 1) * Math.min(oval.rx(), oval.ry()));
        }
        return Math.max(0, point.distanceTo(figure.centre()) - figure.reach());
    }

    private static double leastAcross(Box box, Oval oval, double u) {
        double end = Math.sqrt((1 - u) * (1 + u));
        return least(v -> outside(box, oval.toWorld(new Vec(oval.rx() * u, oval.ry() * v))), -end, end);
    }

    /** The least value of a convex function. */
    private static double least(DoubleUnaryOperator function, double from, double to) {
        double low = from;
        double high = to;
        double best = Math.min(function.applyAsDouble(low), function.applyAsDouble(high));
        for (int step = 0; step < STEPS && low < high; step++) {
            double first = low + (high - low) / 3;
            double second = high - (high - low) / 3;
            double atFirst = function.applyAsDouble(first);
            double atSecond = function.applyAsDouble(second);
            best = Math.min(best, Math.min(atFirst, atSecond));
            if (atFirst <= atSecond) {
                high = second;
            }
            if (atSecond <= atFirst) {
                low = first;
            }
        }
        return best;
    }
}
