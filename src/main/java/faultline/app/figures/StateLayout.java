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
 * Where the states of a diagram stand: on a circle, in the order that makes the fewest arrows cross, and among those the shortest; arrows bend to their left, so
 * that two which lead to and fro lie apart.
 */
final class StateLayout {

    private static final double BEND = 0.22;
    private static final int POINTS = 40;

    private final Map<FollowerState, Vec> places = new EnumMap<>(FollowerState.class);

    private StateLayout(List<FollowerState> order, Vec centre, double radius) {
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
        return new StateLayout(best, centre, radius);
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
        StateLayout layout = new StateLayout(order, Vec.ZERO, 1);
        double cost = 0;
        for (Arrow one : arrows) {
            cost += layout.place(one.from()).distanceTo(layout.place(one.to()));
            cost += 100 * arrows.stream().filter(other -> layout.cross(one, other)).count();
        }
        return cost;
    }

    private boolean cross(Arrow one, Arrow other) {
        boolean touch = one.from() == other.from() || one.from() == other.to() || one.to() == other.from() || one.to() == other.to();
        return !touch && apart(one, other) && apart(other, one);
    }

    /** Whether the second arrow's ends lie on either side of the first. */
    private boolean apart(Arrow line, Arrow ends) {
        Vec way = place(line.to()).minus(place(line.from()));
        return way.cross(place(ends.from()).minus(place(line.from()))) * way.cross(place(ends.to()).minus(place(line.from()))) < 0;
    }

    Vec place(FollowerState state) {
        return places.get(state);
    }

    /** An arrow's curve between the rims of its states. */
    List<Vec> curve(Arrow arrow, double rim) {
        Vec from = place(arrow.from());
        Vec to = place(arrow.to());
        Vec bend = from.plus(to).times(0.5).plus(to.minus(from).perpendicular().times(BEND));
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
