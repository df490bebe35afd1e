package faultline.geometry;

import java.util.function.DoubleUnaryOperator;

/**
 * An independent oracle of the distance between a box and a convex figure: how far a point lies outside a box is a
 * convex function of the point, and its least value over a convex figure is found by ternary search, nested for a
 * figure with an inside.
 */
public final class BoxDistanceOracle {

    private static final int STEPS = 90;

    private BoxDistanceOracle() {}

    /** The distance, metres, 0 where they overlap. */
    public static double distance(OrientedBox box, ConvexShape figure) {
        return figure instanceof Disc disc
                ? Math.max(0, outside(box, disc.centre()) - disc.radius())
                : outside(box, nearest(box, figure));
    }

    /** The figure's point nearest to the box; where they overlap, some point in both or, of a disc, its centre. */
    public static Vector2 nearest(OrientedBox box, ConvexShape figure) {
        if (figure instanceof Segment segment) {
            return segment.pointAt(minimizer(share -> outside(box, segment.pointAt(share)), 0, 1));
        }
        if (figure instanceof Ellipse oval) {
            double u = minimizer(at -> outside(box, minimizerAcross(box, oval, at)), -1, 1);
            return minimizerAcross(box, oval, u);
        }
        return nearestOnDisc((Disc) figure, box);
    }

    private static Vector2 nearestOnDisc(Disc disc, OrientedBox box) {
        double reach = outside(box, disc.centre());
        // The slope of the distance points away from the box.
        double h = 1e-6 * Math.max(reach, 1e-6);
        double dx = outside(box, disc.centre().plus(new Vector2(h, 0)))
                - outside(box, disc.centre().minus(new Vector2(h, 0)));
        double dy = outside(box, disc.centre().plus(new Vector2(0, h)))
                - outside(box, disc.centre().minus(new Vector2(0, h)));
        return reach == 0
                ? disc.centre()
                : disc.centre().minus(new Vector2(dx, dy).times(disc.radius() / Math.hypot(dx, dy)));
    }

    /** How far a point lies outside a box, metres, 0 inside. */
    public static double outside(OrientedBox box, Vector2 point) {
        double dx = point.x() - box.frame().x();
        double dy = point.y() - box.frame().y();
        double ahead = Math.abs(box.frame().cos() * dx + box.frame().sin() * dy) - box.halfLength();
        double aside = Math.abs(box.frame().cos() * dy - box.frame().sin() * dx) - box.halfWidth();
        return Math.hypot(Math.max(0, ahead), Math.max(0, aside));
    }

    /**
     * How far a point lies outside a figure, metres, 0 inside; for an ellipse a bound from its level, good on its
     * outline.
     */
    public static double outside(ConvexShape figure, Vector2 point) {
        if (figure instanceof Segment segment) {
            return point.distanceTo(
                    segment.pointAt(minimizer(share -> point.distanceTo(segment.pointAt(share)), 0, 1)));
        }
        if (figure instanceof Ellipse oval) {
            Vector2 local = oval.frame().toLocal(point);
            double level = Math.hypot(local.x() / oval.rx(), local.y() / oval.ry());
            return Math.max(0, (level - 1) * Math.min(oval.rx(), oval.ry()));
        }
        return Math.max(0, point.distanceTo(figure.centre()) - figure.boundingRadius());
    }

    private static Vector2 minimizerAcross(OrientedBox box, Ellipse oval, double u) {
        double end = Math.sqrt((1 - u) * (1 + u));
        double v = minimizer(
                at -> outside(box, oval.frame().toParent(new Vector2(oval.rx() * u, oval.ry() * at))), -end, end);
        return oval.frame().toParent(new Vector2(oval.rx() * u, oval.ry() * v));
    }

    /** Where a convex function is least. */
    private static double minimizer(DoubleUnaryOperator function, double from, double to) {
        double low = from;
        double high = to;
        for (int step = 0; step < STEPS && low < high; step++) {
            double first = low + (high - low) / 3;
            double second = high - (high - low) / 3;
            double atFirst = function.applyAsDouble(first);
            double atSecond = function.applyAsDouble(second);
            if (atFirst <= atSecond) {
                high = second;
            }
            if (atSecond <= atFirst) {
                low = first;
            }
        }
        double middle = (low + high) / 2;
        double atEnds = Math.min(function.applyAsDouble(from), function.applyAsDouble(to));
        return function.applyAsDouble(middle) <= atEnds ? middle : function.applyAsDouble(from) == atEnds ? from : to;
    }
}
