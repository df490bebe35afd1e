package faultline.engine.metrics;

import faultline.geometry.Vector2;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;

/**
 * The closed paths along the walls of a world at one distance: the places at that distance from a wall and not nearer
 * to any other wall, joined to connected paths. Immutable; runs in the same world can share one.
 */
public final class WallCircuit {

    private final List<WallReference.WallSample> places;
    private final double tolerance;
    private final int[] paths;
    private final double[] lengths;

    /** The places of each cell: those of a bucket of a hash table are linked by {@link #next}. */
    private final int[] first;

    private final int[] next;
    private final long[] cells;

    /**
     * {@return the circuit that the robot's centre can drive along the walls of a world, for {@link CarryOnMetrics}}
     *
     * @param world before anything moves
     * @param distance the distance from a wall to the robot's centre, metres
     */
    public static WallCircuit forCarryOn(WorldSpec world, double distance) {
        double spacing = 0.02;
        return new WallCircuit(new WallReference(world).samplesAlongPath(distance, spacing), spacing, 0.04, 0.15);
    }

    /** {@return a circuit without any path, for robots that follow no wall} */
    public static WallCircuit empty() {
        return new WallCircuit(List.of(), 1, 1, 1);
    }

    /**
     * Joins places into paths.
     *
     * @param places the places, in the order of the walls
     * @param spacing the spacing of the places, metres
     * @param joinDistance places nearer to each other than this belong to one path, metres
     * @param tolerance the maximum distance from a place at which a robot passes it, at least the join distance, metres
     */
    WallCircuit(List<WallReference.WallSample> places, double spacing, double joinDistance, double tolerance) {
        this.places = new ArrayList<>(places);
        this.tolerance = tolerance;
        int count = places.size();
        paths = new int[count];
        lengths = new double[count];
        next = new int[count];
        cells = new long[count];
        first = new int[Integer.highestOneBit(2 * count + 1) * 2];
        Arrays.fill(first, -1);
        for (int i = 0; i < count; i++) {
            paths[i] = i;
            joinWithEarlier(i, joinDistance);
            addToCell(i);
        }
        for (int i = 0; i < count; i++) {
            paths[i] = root(i);
            lengths[paths[i]] += spacing;
        }
    }

    private void joinWithEarlier(int i, double joinDistance) {
        forEachNear(places.get(i).position(), joinDistance, other -> {
            int a = root(i);
            int b = root(other);
            paths[Math.max(a, b)] = Math.min(a, b);
        });
    }

    private int root(int i) {
        int at = i;
        while (paths[at] != at) {
            paths[at] = paths[paths[at]];
            at = paths[at];
        }
        return at;
    }

    private void addToCell(int i) {
        Vector2 position = places.get(i).position();
        cells[i] = cell(column(position.x()), column(position.y()));
        int bucket = bucket(cells[i]);
        next[i] = first[bucket];
        first[bucket] = i;
    }

    private long column(double coordinate) {
        return (long) Math.floor(coordinate / tolerance);
    }

    private static long cell(long column, long row) {
        return column << 32 ^ row & 0xFFFF_FFFFL;
    }

    private int bucket(long cell) {
        long mixed = cell * 0x9E37_79B9_7F4A_7C15L;
        return (int) (mixed >>> 32) & first.length - 1;
    }

    /** Calls an action for every place within a radius of at most the tolerance around a point. */
    void forEachNear(Vector2 point, double radius, IntConsumer action) {
        long column = column(point.x());
        long row = column(point.y());
        for (long x = column - 1; x <= column + 1; x++) {
            for (long y = row - 1; y <= row + 1; y++) {
                long cell = cell(x, y);
                for (int i = first[bucket(cell)]; i >= 0; i = next[i]) {
                    if (cells[i] == cell && places.get(i).position().distanceTo(point) <= radius) {
                        action.accept(i);
                    }
                }
            }
        }
    }

    /** Calls back with every place that a robot passes at a point. */
    void forEachPassed(Vector2 point, IntConsumer action) {
        forEachNear(point, tolerance, action);
    }

    /** Returns how many places there are on all paths together. */
    int size() {
        return places.size();
    }

    /** Returns the path that a place is on, identified by its first place. */
    int path(int place) {
        return paths[place];
    }

    /** Returns the length of wall that belongs to a place, metres. */
    double wallLength(int place) {
        return places.get(place).wallLength();
    }

    /** Returns the approximate length of a path, metres. */
    double length(int path) {
        return lengths[path];
    }

    /** Returns the length of the longest path, metres; 0 if there is none. */
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
        for (int i = 0; i < paths.length; i++) {
            double distance = places.get(i).position().distanceTo(point);
            if (distance < least) {
                least = distance;
                nearest = i;
            }
        }
        return nearest;
    }
}
