package faultline.engine.metrics;

import faultline.geometry.Vector2;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;

/**
 * The ways along the walls of a world at one distance: places at that distance from a wall and nowhere nearer to any,
 * joined to connected ways. Immutable; runs in the same world can share one.
 */
public final class WallCircuit {

    /** How far from the wanted way a robot still passes a place of it, metres. */
    static final double TOLERANCE = 0.15;

    private static final double SPACING = 0.02;
    /** Places nearer to each other than this belong to one way, metres. */
    private static final double JOIN_DISTANCE = 0.04;

    private final List<WallReference.Sample> places;
    private final int[] ways;
    private final double[] lengths;
    private final Map<Long, List<Integer>> cells = new HashMap<>();

    /**
     * Finds the ways of a world.
     *
     * @param world before anything moves
     * @param distance from a wall to the robot's centre, metres
     */
    public WallCircuit(WorldSpec world, double distance) {
        this(new WallReference(world).samplesAlongWay(distance, SPACING));
    }

    /** Returns a circuit without any way, for robots that follow no wall. */
    public static WallCircuit empty() {
        return new WallCircuit(List.of());
    }

    private WallCircuit(List<WallReference.Sample> samples) {
        places = samples;
        ways = new int[places.size()];
        lengths = new double[places.size()];
        for (int i = 0; i < ways.length; i++) {
            ways[i] = i;
            joinWithEarlier(i);
            cells.computeIfAbsent(cell(places.get(i).position(), 0, 0), key -> new ArrayList<>())
                    .add(i);
        }
        for (int i = 0; i < ways.length; i++) {
            ways[i] = root(i);
            lengths[ways[i]] += SPACING;
        }
    }

    private void joinWithEarlier(int i) {
        Vector2 position = places.get(i).position();
        forEachNear(position, JOIN_DISTANCE, other -> {
            int a = root(i);
            int b = root(other);
            ways[Math.max(a, b)] = Math.min(a, b);
        });
    }

    private int root(int i) {
        int at = i;
        while (ways[at] != at) {
            ways[at] = ways[ways[at]];
            at = ways[at];
        }
        return at;
    }

    private static long cell(Vector2 point, int dx, int dy) {
        long column = (long) Math.floor(point.x() / TOLERANCE) + dx;
        long row = (long) Math.floor(point.y() / TOLERANCE) + dy;
        return column * 0x1_0000_0001L ^ row << 21;
    }

    /** Calls back with every place within a radius of at most {@link #TOLERANCE} of a point. */
    void forEachNear(Vector2 point, double radius, IntConsumer action) {
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                for (int i : cells.getOrDefault(cell(point, dx, dy), List.of())) {
                    if (places.get(i).position().distanceTo(point) <= radius) {
                        action.accept(i);
                    }
                }
            }
        }
    }

    /** Returns how many places there are on all ways together. */
    int size() {
        return places.size();
    }

    /** Returns the way that a place is on, named by the first place of it. */
    int way(int place) {
        return ways[place];
    }

    /** Returns the length of wall that belongs to a place, metres. */
    double wallLength(int place) {
        return places.get(place).wallLength();
    }

    /** Returns about how long a way is, metres. */
    double length(int way) {
        return lengths[way];
    }

    /** Returns the length of the longest way, metres; 0 if there is none. */
    double maxLength() {
        double most = 0;
        for (double length : lengths) {
            most = Math.max(most, length);
        }
        return most;
    }

    /** Returns the place nearest to a point, -1 if there is none. */
    int nearestPlace(Vector2 point) {
        int nearest = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ways.length; i++) {
            double distance = places.get(i).position().distanceTo(point);
            if (distance < least) {
                least = distance;
                nearest = i;
            }
        }
        return nearest;
    }
}
