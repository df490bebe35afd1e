package faultline.engine.walls;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.stream.DoubleStream;

/**
 * The closed paths along the walls of a world at one distance: the places at that distance from a wall and not nearer
 * to any other wall, joined to connected paths. Does not change; runs in the same world can share one, also in several
 * threads.
 */
public final class WallCircuit {

    private final List<WallReference.WallSample> places;
    private final double tolerance;
    private final double spacing;
    private final int[] paths;
    private final double[] lengths;
    private final double maxLength;
    /** The coordinates of the places, which are compared most. */
    private final double[] xs;

    private final double[] ys;

    /** The last place of each cell, and for each place the one before it in its cell. */
    private final CellNumbers lastInCell = new CellNumbers();

    private final int[] before;

    private final Function<WallCircuit, BodyPaths> bodyFinder;
    /** Null until they are needed, because finding them may take longer than finding this circuit. */
    private BodyPaths bodyPaths;

    /** {@return a circuit without any path, for robots that follow no wall} */
    public static WallCircuit empty() {
        return new WallCircuit(List.of(), 1, 1, 1);
    }

    /**
     * Joins places into paths; those of the body are the same.
     *
     * @param places the places, in the order of the walls
     * @param spacing the spacing of the places, metres
     * @param joinDistance places nearer to each other than this belong to one path, metres
     * @param tolerance the maximum distance from a place at which a robot passes it, at least the join distance, metres
     */
    public WallCircuit(List<WallReference.WallSample> places, double spacing, double joinDistance, double tolerance) {
        this(places, spacing, joinDistance, tolerance, BodyPaths::same);
    }

    /**
     * Joins places into paths.
     *
     * @param places the places, in the order of the walls
     * @param spacing the spacing of the places, metres
     * @param joinDistance places nearer to each other than this belong to one path, metres
     * @param tolerance the maximum distance from a place at which a robot passes it, at least the join distance, metres
     * @param bodyFinder finds the paths of the body
     */
    public WallCircuit(
            List<WallReference.WallSample> places,
            double spacing,
            double joinDistance,
            double tolerance,
            Function<WallCircuit, BodyPaths> bodyFinder) {
        this.places = new ArrayList<>(places);
        this.spacing = spacing;
        this.tolerance = tolerance;
        this.bodyFinder = bodyFinder;
        int count = places.size();
        paths = new int[count];
        lengths = new double[count];
        xs = places.stream().mapToDouble(place -> place.position().x()).toArray();
        ys = places.stream().mapToDouble(place -> place.position().y()).toArray();
        before = new int[count];
        JoinedPlaces joined = new JoinedPlaces(this.places, joinDistance);
        for (int i = 0; i < count; i++) {
            addToCell(i);
            paths[i] = joined.path(i);
            lengths[paths[i]] += spacing;
        }
        maxLength = DoubleStream.of(lengths).max().orElse(0);
    }

    private void addToCell(int i) {
        long cell = CellKey.of(column(xs[i]), column(ys[i]));
        before[i] = lastInCell.get(cell);
        lastInCell.put(cell, i);
    }

    private long column(double coordinate) {
        return CellKey.index(coordinate, tolerance);
    }

    /** Calls an action with the last place of every cell that can have places within a radius of a point. */
    private void forEachCell(double atX, double atY, double radius, IntConsumer action) {
        // Other cells contain no place within the radius, not even after rounding.
        double reach = radius + WallReference.ROUNDING;
        long left = Math.max(column(atX - reach), column(atX) - 1);
        long right = Math.min(column(atX + reach), column(atX) + 1);
        long bottom = Math.max(column(atY - reach), column(atY) - 1);
        long top = Math.min(column(atY + reach), column(atY) + 1);
        for (long x = left; x <= right; x++) {
            for (long y = bottom; y <= top; y++) {
                action.accept(lastInCell.get(CellKey.of(x, y)));
            }
        }
    }

    /** Returns the distance of a place from a point. */
    private double distance(int place, double x, double y) {
        double dx = x - xs[place];
        double dy = y - ys[place];
        return Math.sqrt(dx * dx + dy * dy);
    }

    /**
     * Calls back with every place that a robot passes at a point.
     *
     * @param point the robot's centre
     * @param action takes the indices of the places
     */
    public void forEachPassed(Vector2 point, IntConsumer action) {
        forEachCell(point.x(), point.y(), tolerance, last -> {
            for (int i = last; i != CellNumbers.NONE; i = before[i]) {
                if (distance(i, point.x(), point.y()) <= tolerance) {
                    action.accept(i);
                }
            }
        });
    }

    /**
     * {@return the distance of a place from a point, metres}
     *
     * @param place the index of the place
     * @param point the point
     */
    public double distance(int place, Vector2 point) {
        return distance(place, point.x(), point.y());
    }

    /**
     * {@return how far a robot with the wall of a place on its left drives along it, metres; negative if it drives back
     * or if the wall is on its right}
     *
     * @param place the index of the place
     * @param from where the robot's centre was
     * @param to where it is
     */
    public double ahead(int place, Vector2 from, Vector2 to) {
        Vector2 offset = places.get(place).offset();
        return offset.cross(to.minus(from)) / offset.length();
    }

    /** {@return the paths of the body, found by the first call} */
    public synchronized BodyPaths bodyPaths() {
        if (bodyPaths == null) {
            bodyPaths = bodyFinder.apply(this);
        }
        return bodyPaths;
    }

    /** Returns a place. */
    WallReference.WallSample place(int index) {
        return places.get(index);
    }

    /** Returns the spacing of the places, metres. */
    double spacing() {
        return spacing;
    }

    /** {@return how many places there are on all paths together} */
    public int size() {
        return places.size();
    }

    /**
     * {@return the path that a place is on, identified by its first place}
     *
     * @param place the index of the place
     */
    public int path(int place) {
        return paths[place];
    }

    /**
     * {@return the length of wall that belongs to a place, metres}
     *
     * @param place the index of the place
     */
    public double wallLength(int place) {
        return places.get(place).wallLength();
    }

    /**
     * {@return the approximate length of a path, metres}
     *
     * @param path the index of its first place
     */
    public double length(int path) {
        return lengths[path];
    }

    /** {@return the length of the longest path, metres; 0 if there is none} */
    public double maxLength() {
        return maxLength;
    }

    /**
     * {@return the index of the place nearest to a point, -1 if there is none}
     *
     * @param point the point
     */
    public int nearestPlace(Vector2 point) {
        int nearest = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < paths.length; i++) {
            double distance = distance(i, point.x(), point.y());
            if (distance < least) {
                least = distance;
                nearest = i;
            }
        }
        return nearest;
    }
}
