package faultline.engine.walls;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntConsumer;

/**
 * Points by their cells, so that those within a radius are found. Around a thin ellipse or several equal walls,
 * thousands can be in one cell, so those that are very near to each other make a run, and are compared with other
 * points as one. The first point of a run identifies it.
 */
final class PointRuns {

    /** The radius of a run, as a share of that of a search: two points of a run are always within that of a search. */
    private static final double RUN_RADIUS = 1 / 32.0;

    private static final int NONE = CellNumbers.NONE;

    private final double radius;
    /** Slightly more than the radius, so that rounding separates no two points by a cell. */
    private final double cellSize;

    private final List<Vector2> points = new ArrayList<>();
    private final CellNumbers firstRuns = new CellNumbers();
    private final BitSet closed = new BitSet();

    /** The next run of the same cell for a run, and the next point of the same kind in its run for any other point. */
    private int[] next = new int[1024];
    /** For each run one of the other points at exactly the same place. */
    private int[] twins = new int[1024];
    /** For each run one of the points at other places. */
    private int[] others = new int[1024];

    /** Creates a list without points for searches within a radius, metres. */
    PointRuns(double radius) {
        this.radius = radius;
        cellSize = radius * (1 + 1e-9) + WallReference.ROUNDING;
    }

    /** Adds a point, and returns its run: a new one if none that is open is near enough. */
    int add(Vector2 point) {
        int number = points.size();
        points.add(point);
        if (number == next.length) {
            next = Arrays.copyOf(next, 2 * number);
            twins = Arrays.copyOf(twins, 2 * number);
            others = Arrays.copyOf(others, 2 * number);
        }
        long cell = CellKey.of(point, cellSize);
        int first = firstRuns.get(cell);
        for (int run = first; run != NONE; run = next[run]) {
            double distance =
                    closed.get(run) ? Double.POSITIVE_INFINITY : points.get(run).distanceTo(point);
            if (distance <= RUN_RADIUS * radius) {
                int[] list = distance == 0 ? twins : others;
                next[number] = list[run];
                list[run] = number;
                return run;
            }
        }
        twins[number] = NONE;
        others[number] = NONE;
        next[number] = first;
        firstRuns.put(cell, number);
        return number;
    }

    /** Returns whether a point is at the same place as the first one of its run. */
    boolean isTwin(int number, int run) {
        return number != run && points.get(run).distanceTo(points.get(number)) == 0;
    }

    /** Closes a run: it takes no more points and is no longer found. */
    void close(int run) {
        closed.set(run);
    }

    /** Calls an action with each open run of which a point is within the radius of a point. */
    void forEachNear(Vector2 point, IntConsumer action) {
        long column = CellKey.index(point.x(), cellSize);
        long row = CellKey.index(point.y(), cellSize);
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                for (int run = firstRuns.get(CellKey.of(column + dx, row + dy)); run != NONE; run = next[run]) {
                    if (!closed.get(run) && isNear(run, point)) {
                        action.accept(run);
                    }
                }
            }
        }
    }

    private boolean isNear(int run, Vector2 point) {
        double toFirst = points.get(run).distanceTo(point);
        // The others are at most the radius of the run away.
        boolean near = toFirst <= radius;
        int other = toFirst <= (1 + 2 * RUN_RADIUS) * radius ? others[run] : NONE;
        for (; other != NONE && !near; other = next[other]) {
            near = points.get(other).distanceTo(point) <= radius;
        }
        return near;
    }

    /** Calls an action with each point of a run. */
    void forEachPoint(int run, IntConsumer action) {
        action.accept(run);
        for (int point = twins[run]; point != NONE; point = next[point]) {
            action.accept(point);
        }
        for (int point = others[run]; point != NONE; point = next[point]) {
            action.accept(point);
        }
    }
}
