package faultline.engine.metrics;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * The share of the wall that was followed. The robot's offset path, that is, all places at the wanted distance from a
 * wall and nowhere nearer to any, falls into connected pieces; the piece of which the robot passed most is the wall
 * that it followed. A place is passed if the robot's centre came within {@link #TOLERANCE} of it.
 */
final class Coverage {

    /** How far from the wanted place the robot may pass, metres. */
    static final double TOLERANCE = 0.05;

    /** Samples along the walls are this far apart, metres. */
    private static final double SPACING = 0.01;

    /** Places nearer to each other than this are joined, metres. */
    private static final double JOIN_DISTANCE = 0.025;

    /** Points of the way nearer to the last one than this are not looked at, metres. */
    private static final double MIN_STEP = 0.002;

    private final WallReference walls;
    private final double distance;
    private final Map<Long, Vector2> visited = new HashMap<>();
    /** Visited points whose places are not yet marked as passed. */
    private final List<Vector2> pending = new ArrayList<>();

    private Vector2 last = new Vector2(Double.POSITIVE_INFINITY, 0);
    /** Made when they are first needed, because that takes long in large worlds. */
    private List<WallReference.Sample> places;

    private int[] pieces;
    private boolean[] passed;
    private final Map<Long, List<Integer>> placesByCell = new HashMap<>();
    private double share = Double.NaN;

    /** A record of passing walls at a distance from the robot's centre, metres. */
    Coverage(WallReference walls, double distance) {
        this.walls = walls;
        this.distance = distance;
    }

    /** Notes that the robot's centre was at a point; one point a square centimetre is kept. */
    void visit(Vector2 centre) {
        if (centre.distanceTo(last) >= MIN_STEP) {
            if (visited.putIfAbsent(cell(centre, SPACING, 0, 0), centre) == null) {
                pending.add(centre);
            }
            last = centre;
        }
    }

    private static long cell(Vector2 point, double size, int dx, int dy) {
        long column = (long) Math.floor(point.x() / size) + dx;
        long row = (long) Math.floor(point.y() / size) + dy;
        return column * 0x1_0000_0001L ^ row << 21;
    }

    /**
     * The share so far, in [0, 1]; empty where nothing was passed. Costs what was visited since the last call, so it
     * may be asked for again and again while the run goes on.
     */
    OptionalDouble share() {
        if (!pending.isEmpty()) {
            findPlaces();
            pending.forEach(this::markPassed);
            pending.clear();
            share = computeShare();
        }
        return Double.isNaN(share) ? OptionalDouble.empty() : OptionalDouble.of(share);
    }

    private void findPlaces() {
        if (places == null) {
            places = walls.samples(distance, SPACING);
            pieces = connectedPieces(places);
            passed = new boolean[places.size()];
            for (int i = 0; i < passed.length; i++) {
                placesByCell
                        .computeIfAbsent(cell(places.get(i).position(), TOLERANCE, 0, 0), key -> new ArrayList<>())
                        .add(i);
            }
        }
    }

    private void markPassed(Vector2 point) {
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                for (int i : placesByCell.getOrDefault(cell(point, TOLERANCE, dx, dy), List.of())) {
                    passed[i] |= places.get(i).position().distanceTo(point) <= TOLERANCE;
                }
            }
        }
    }

    private double computeShare() {
        double[] passedLength = new double[passed.length];
        double[] length = new double[passed.length];
        for (int i = 0; i < passed.length; i++) {
            length[pieces[i]] += places.get(i).wallLength();
            passedLength[pieces[i]] += passed[i] ? places.get(i).wallLength() : 0;
        }
        int most = 0;
        for (int i = 1; i < passed.length; i++) {
            most = passedLength[i] > passedLength[most] ? i : most;
        }
        return passed.length == 0 || passedLength[most] == 0 ? Double.NaN : passedLength[most] / length[most];
    }

    /** The connected piece of each place, named by the first place in it. */
    private static int[] connectedPieces(List<WallReference.Sample> places) {
        int[] parent = new int[places.size()];
        Map<Long, List<Integer>> cells = new HashMap<>();
        for (int i = 0; i < parent.length; i++) {
            parent[i] = i;
            Vector2 at = places.get(i).position();
            for (int dx = -1; dx <= 1; dx++) {
                for (int dy = -1; dy <= 1; dy++) {
                    for (int other : cells.getOrDefault(cell(at, JOIN_DISTANCE, dx, dy), List.of())) {
                        if (places.get(other).position().distanceTo(at) <= JOIN_DISTANCE) {
                            join(parent, i, other);
                        }
                    }
                }
            }
            cells.computeIfAbsent(cell(at, JOIN_DISTANCE, 0, 0), key -> new ArrayList<>())
                    .add(i);
        }
        for (int i = 0; i < parent.length; i++) {
            parent[i] = root(parent, i);
        }
        return parent;
    }

    private static void join(int[] parent, int one, int other) {
        int a = root(parent, one);
        int b = root(parent, other);
        parent[Math.max(a, b)] = Math.min(a, b);
    }

    private static int root(int[] parent, int i) {
        int at = i;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }
}
