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
    private Vector2 last = new Vector2(Double.POSITIVE_INFINITY, 0);

    /** A record of passing walls at a distance from the robot's centre, metres. */
    Coverage(WallReference walls, double distance) {
        this.walls = walls;
        this.distance = distance;
    }

    /** Notes that the robot's centre was at a point; one point a square centimetre is kept. */
    void visit(Vector2 centre) {
        if (centre.distanceTo(last) >= MIN_STEP) {
            visited.putIfAbsent(cell(centre, SPACING, 0, 0), centre);
            last = centre;
        }
    }

    private static long cell(Vector2 point, double size, int dx, int dy) {
        long column = (long) Math.floor(point.x() / size) + dx;
        long row = (long) Math.floor(point.y() / size) + dy;
        return column * 0x1_0000_0001L ^ row << 21;
    }

    /** The share, in [0, 1]; empty where nothing was passed. */
    OptionalDouble share() {
        if (visited.isEmpty()) {
            return OptionalDouble.empty();
        }
        List<WallReference.Sample> places = walls.samples(distance, SPACING);
        int[] pieces = connectedPieces(places);
        double[] passed = new double[places.size()];
        double[] all = new double[places.size()];
        for (int i = 0; i < places.size(); i++) {
            all[pieces[i]] += places.get(i).wallLength();
            passed[pieces[i]] +=
                    isPassed(places.get(i).position()) ? places.get(i).wallLength() : 0;
        }
        int most = 0;
        for (int i = 1; i < passed.length; i++) {
            most = passed[i] > passed[most] ? i : most;
        }
        return passed.length == 0 || passed[most] == 0
                ? OptionalDouble.empty()
                : OptionalDouble.of(passed[most] / all[most]);
    }

    private boolean isPassed(Vector2 place) {
        int reach = (int) Math.ceil(TOLERANCE / SPACING);
        for (int dx = -reach; dx <= reach; dx++) {
            for (int dy = -reach; dy <= reach; dy++) {
                Vector2 point = visited.get(cell(place, SPACING, dx, dy));
                if (point != null && point.distanceTo(place) <= TOLERANCE) {
                    return true;
                }
            }
        }
        return false;
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
