package faultline.engine;

import faultline.geometry.Vec;
import faultline.world.WallMap;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * The share of the wall that was followed. The robot's offset path, that is, all places at the wanted distance from a wall and nowhere
 * nearer to any, falls into connected pieces; the piece of which the robot passed most is the wall that it followed. A place is passed if
 * the robot's centre came within {@link #BAND} of it.
 */
final class Coverage {

    /** How far from the wanted place the robot may pass, metres. */
    static final double BAND = 0.05;

    /** Samples along the walls are this far apart, metres. */
    private static final double SPACING = 0.01;

    /** Places nearer to each other than this are joined, metres. */
    private static final double JOINED = 0.025;

    /** Points of the way nearer to the last one than this are not looked at, metres. */
    private static final double STEP = 0.002;

    private final WallMap walls;
    private final double distance;
    private final Map<Long, Vec> visited = new HashMap<>();
    private Vec last = new Vec(Double.POSITIVE_INFINITY, 0);

    /** A record of passing walls at a distance from the robot's centre, metres. */
    Coverage(WallMap walls, double distance) {
        this.walls = walls;
        this.distance = distance;
    }

    /** Notes that the robot's centre was at a point; one point a square centimetre is kept. */
    void visit(Vec centre) {
        if (centre.distanceTo(last) >= STEP) {
            visited.putIfAbsent(cell(centre, SPACING, 0, 0), centre);
            last = centre;
        }
    }

    private static long cell(Vec point, double size, int dx, int dy) {
        long column = (long) Math.floor(point.x() / size) + dx;
        long row = (long) Math.floor(point.y() / size) + dy;
        return column * 0x1_0000_0001L ^ row << 21;
    }

    /** The share, in [0, 1]; empty where nothing was passed. */
    OptionalDouble share() {
        if (visited.isEmpty()) {
            return OptionalDouble.empty();
        }
        List<WallMap.Place> places = walls.places(distance, SPACING);
        int[] pieces = pieces(places);
        double[] passed = new double[places.size()];
        double[] all = new double[places.size()];
        for (int i = 0; i < places.size(); i++) {
            all[pieces[i]] += places.get(i).length();
            passed[pieces[i]] += isPassed(places.get(i).at()) ? places.get(i).length() : 0;
        }
        int most = 0;
        for (int i = 1; i < passed.length; i++) {
            most = passed[i] > passed[most] ? i : most;
        }
        return passed.length == 0 || passed[most] == 0 ? OptionalDouble.empty() : OptionalDouble.of(passed[most] / all[most]);
    }

    private boolean isPassed(Vec place) {
        int reach = (int) Math.ceil(BAND / SPACING);
        for (int dx = -reach; dx <= reach; dx++) {
            for (int dy = -reach; dy <= reach; dy++) {
                Vec point = visited.get(cell(place, SPACING, dx, dy));
                if (point != null && point.distanceTo(place) <= BAND) {
                    return true;
                }
            }
        }
        return false;
    }

    /** The connected piece of each place, named by the first place in it. */
    private static int[] pieces(List<WallMap.Place> places) {
        int[] parent = new int[places.size()];
        Map<Long, List<Integer>> cells = new HashMap<>();
        for (int i = 0; i < parent.length; i++) {
            parent[i] = i;
            Vec at = places.get(i).at();
            for (int dx = -1; dx <= 1; dx++) {
                for (int dy = -1; dy <= 1; dy++) {
                    for (int other : cells.getOrDefault(cell(at, JOINED, dx, dy), List.of())) {
                        if (places.get(other).at().distanceTo(at) <= JOINED) {
                            join(parent, i, other);
                        }
                    }
                }
            }
            cells.computeIfAbsent(cell(at, JOINED, 0, 0), key -> new ArrayList<>()).add(i);
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
