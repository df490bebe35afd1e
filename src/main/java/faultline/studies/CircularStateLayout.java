package faultline.studies;

import faultline.control.FollowerState;
import faultline.control.wallfollower.StateDiagram.Arrow;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * The positions of the states of a diagram: on a circle, in the order with the fewest crossings of arrows and, among
 * those, the shortest arrows. Arrows are straight, but two opposite arrows bend to their left, so that they do not
 * coincide.
 */
final class CircularStateLayout {

    private static final double BEND = 0.22;
    private static final int CURVE_POINTS = 40;
    /** The step between the points of a curve that are checked for crossings. */
    private static final int COARSE_STEP = 5;

    private final Map<FollowerState, Vector2> positions = new EnumMap<>(FollowerState.class);
    private final List<Arrow> arrows;

    private CircularStateLayout(List<FollowerState> order, List<Arrow> arrows, Vector2 centre, double radius) {
        this.arrows = arrows;
        for (int i = 0; i < order.size(); i++) {
            double bearing = StrictMath.PI * (-2.0 / 3 + 2.0 * i / order.size());
            positions.put(order.get(i), centre.plus(Vector2.direction(bearing).times(radius)));
        }
    }

    static CircularStateLayout of(List<Arrow> arrows, Vector2 centre, double radius) {
        List<FollowerState> states = List.of(FollowerState.values());
        List<FollowerState> best = states;
        double least = Double.POSITIVE_INFINITY;
        for (List<FollowerState> order : permutations(states.subList(0, 1), states.subList(1, states.size()))) {
            double cost = cost(order, arrows);
            if (cost < least) {
                least = cost;
                best = order;
            }
        }
        return new CircularStateLayout(best, arrows, centre, radius);
    }

    /** Returns all orders that begin with some states. */
    private static List<List<FollowerState>> permutations(List<FollowerState> begun, List<FollowerState> left) {
        if (left.isEmpty()) {
            return List.of(begun);
        }
        List<List<FollowerState>> orders = new ArrayList<>();
        for (FollowerState next : left) {
            List<FollowerState> longer = new ArrayList<>(begun);
            longer.add(next);
            List<FollowerState> fewer =
                    left.stream().filter(state -> state != next).toList();
            orders.addAll(permutations(longer, fewer));
        }
        return orders;
    }

    /** Returns the cost of an order; a crossing counts more than any length. */
    private static double cost(List<FollowerState> order, List<Arrow> arrows) {
        CircularStateLayout layout = new CircularStateLayout(order, arrows, Vector2.ZERO, 1);
        List<List<Vector2>> curves = arrows.stream().map(layout::coarseCurve).toList();
        double cost = 0;
        for (int i = 0; i < arrows.size(); i++) {
            cost += layout.position(arrows.get(i).from())
                    .distanceTo(layout.position(arrows.get(i).to()));
            for (int j = 0; j < i; j++) {
                cost += intersect(curves.get(i), curves.get(j)) ? 100 : 0;
            }
        }
        return cost;
    }

    private List<Vector2> coarseCurve(Arrow arrow) {
        List<Vector2> curve = curve(arrow, 0);
        return IntStream.range(0, curve.size())
                .filter(i -> i % COARSE_STEP == COARSE_STEP / 2)
                .mapToObj(curve::get)
                .toList();
    }

    private static boolean intersect(List<Vector2> one, List<Vector2> other) {
        for (int i = 1; i < one.size(); i++) {
            for (int j = 1; j < other.size(); j++) {
                if (labelPositions(one.get(i - 1), one.get(i), other.get(j - 1), other.get(j))
                        && labelPositions(other.get(j - 1), other.get(j), one.get(i - 1), one.get(i))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Returns whether two points lie on different sides of a line. */
    private static boolean labelPositions(Vector2 from, Vector2 to, Vector2 one, Vector2 other) {
        Vector2 way = to.minus(from);
        return way.cross(one.minus(from)) * way.cross(other.minus(from)) < 0;
    }

    Vector2 position(FollowerState state) {
        return positions.get(state);
    }

    /** Returns the curve of an arrow between the borders of its states. */
    List<Vector2> curve(Arrow arrow, double rim) {
        Vector2 from = position(arrow.from());
        Vector2 to = position(arrow.to());
        boolean toAndFro = arrows.stream().anyMatch(other -> other.from() == arrow.to() && other.to() == arrow.from());
        Vector2 bend =
                from.plus(to).times(0.5).plus(to.minus(from).perpendicular().times(toAndFro ? BEND : 0));
        return IntStream.rangeClosed(0, CURVE_POINTS)
                .mapToDouble(i -> (double) i / CURVE_POINTS)
                .mapToObj(t -> from.times((1 - t) * (1 - t))
                        .plus(bend.times(2 * t * (1 - t)))
                        .plus(to.times(t * t)))
                .filter(point -> point.distanceTo(from) > rim && point.distanceTo(to) > rim)
                .toList();
    }

    /**
     * Returns a position on each curve for its number: as far as possible from all other curves and from the numbers
     * before it.
     */
    static List<Vector2> labelPositions(List<List<Vector2>> curves) {
        List<Vector2> places = new ArrayList<>();
        for (List<Vector2> curve : curves) {
            List<Vector2> others = new ArrayList<>(places);
            curves.stream().filter(other -> other != curve).forEach(others::addAll);
            List<Vector2> inner = curve.subList(curve.size() / 5, curve.size() * 7 / 10);
            places.add(inner.stream()
                    .max(Comparator.comparingDouble(place -> minDistance(place, others)))
                    .orElseThrow());
        }
        return places;
    }

    private static double minDistance(Vector2 place, List<Vector2> others) {
        return others.stream().mapToDouble(place::distanceTo).min().orElse(Double.POSITIVE_INFINITY);
    }
}
