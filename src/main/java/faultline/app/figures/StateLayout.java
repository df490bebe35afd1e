package faultline.app.figures;

import faultline.control.FollowerState;
import faultline.control.StateDiagram.Arrow;
import faultline.geometry.Vec;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Where the states of a diagram stand: on a circle, in the order that makes the fewest arrows cross, and among those the shortest. Arrows
 * are straight, but two which lead to and fro bend to their left, so that they lie apart.
 */
final class StateLayout {

    private static final double BEND = 0.22;
    private static final int POINTS = 40;
    /** For crossings, every so manieth point of a curve will do. */
    private static final int COARSE = 5;

    private final Map<FollowerState, Vec> places = new EnumMap<>(FollowerState.class);
    private final List<Arrow> arrows;

    private StateLayout(List<FollowerState> order, List<Arrow> arrows, Vec centre, double radius) {
        this.arrows = arrows;
        for (int i = 0; i < order.size(); i++) {
            double bearing = StrictMath.PI * (-2.0 / 3 + 2.0 * i / order.size());
            places.put(order.get(i), centre.plus(Vec.direction(bearing).times(radius)));
        }
    }

    static StateLayout of(List<Arrow> arrows, Vec centre, double radius) {
        List<FollowerState> states = List.of(FollowerState.values());
        List<FollowerState> best = states;
        double least = Double.POSITIVE_INFINITY;
        for (List<FollowerState> order : orders(states.subList(0, 1), states.subList(1, states.size()))) {
            double cost = cost(order, arrows);
            if (cost < least) {
                least = cost;
                best = order;
            }
        }
        return new StateLayout(best, arrows, centre, radius);
    }

    /** All orders that begin with some states. */
    private static List<List<FollowerState>> orders(List<FollowerState> begun, List<FollowerState> left) {
        if (left.isEmpty()) {
            return List.of(begun);
        }
        List<List<FollowerState>> orders = new ArrayList<>();
        for (FollowerState next : left) {
            List<FollowerState> longer = new ArrayList<>(begun);
            longer.add(next);
            List<FollowerState> fewer = left.stream().filter(state -> state != next).toList();
            orders.addAll(orders(longer, fewer));
        }
        return orders;
    }

    /** A crossing counts more than any length. */
    private static double cost(List<FollowerState> order, List<Arrow> arrows) {
        StateLayout layout = new StateLayout(order, arrows, Vec.ZERO, 1);
        List<List<Vec>> curves = arrows.stream().map(layout::coarse).toList();
        double cost = 0;
        for (int i = 0; i < arrows.size(); i++) {
            cost += layout.place(arrows.get(i).from()).distanceTo(layout.place(arrows.get(i).to()));
            for (int j = 0; j < i; j++) {
                cost += cross(curves.get(i), curves.get(j)) ? 100 : 0;
            }
        }
        return cost;
    }

    private List<Vec> coarse(Arrow arrow) {
        List<Vec> curve = curve(arrow, 0);
        return IntStream.range(0, curve.size()).filter(i -> i % COARSE == COARSE / 2).mapToObj(curve::get).toList();
    }

    private static boolean cross(List<Vec> one, List<Vec> other) {
        for (int i = 1; i < one.size(); i++) {
            for (int j = 1; j < other.size(); j++) {
                if (apart(one.get(i - 1), one.get(i), other.get(j - 1), other.get(j))
                        && apart(other.get(j - 1), other.get(j), one.get(i - 1), one.get(i))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether two points lie on either side of a line. */
    private static boolean apart(Vec from, Vec to, Vec one, Vec other) {
        Vec way = to.minus(from);
        return way.cross(one.minus(from)) * way.cross(other.minus(from)) < 0;
    }

    Vec place(FollowerState state) {
        return places.get(state);
    }

    /** An arrow's curve between the rims of its states. */
    List<Vec> curve(Arrow arrow, double rim) {
        Vec from = place(arrow.from());
        Vec to = place(arrow.to());
        boolean toAndFro = arrows.stream().anyMatch(other -> other.from() == arrow.to() && other.to() == arrow.from());
        Vec bend = from.plus(to).times(0.5).plus(to.minus(from).perpendicular().times(toAndFro ? BEND : 0));
        return IntStream.rangeClosed(0, POINTS).mapToDouble(i -> (double) i / POINTS)
                .mapToObj(t -> from.times((1 - t) * (1 - t)).plus(bend.times(2 * t * (1 - t))).plus(to.times(t * t)))
                .filter(point -> point.distanceTo(from) > rim && point.distanceTo(to) > rim).toList();
    }

    /** A place on each curve for its number: as far as can be from all other curves, and from the numbers before it. */
    static List<Vec> apart(List<List<Vec>> curves) {
        List<Vec> places = new ArrayList<>();
        for (List<Vec> curve : curves) {
            List<Vec> others = new ArrayList<>(places);
            curves.stream().filter(other -> other != curve).forEach(others::addAll);
            List<Vec> inner = curve.subList(curve.size() / 5, curve.size() * 7 / 10);
            places.add(inner.stream().max(Comparator.comparingDouble(place -> room(place, others))).orElseThrow());
        }
        return places;
    }

    private static double room(Vec place, List<Vec> others) {
        return others.stream().mapToDouble(place::distanceTo).min().orElse(Double.POSITIVE_INFINITY);
    }
}
