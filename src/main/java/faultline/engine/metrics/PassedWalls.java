package faultline.engine.metrics;

import faultline.engine.walls.DisjointSets;
import faultline.engine.walls.WallCircuit;
import faultline.geometry.Vector2;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;

/**
 * How much a robot has passed of the wall that it follows. A passage can be too narrow for the wanted distance on both
 * sides although the robot's body has room in it. The robot may turn back there, and then follows a path at the wanted
 * distance; or it passes, and then follows a path of its body. The wall counts that is along the path on which the
 * robot is first. When the robot has driven as far as for {@link CarryOnMetrics#REQUIRED_SHARE} of that path, those
 * count as well that it can get to from there by such paths: the one of all of them of which it has passed the greatest
 * share.
 */
final class PassedWalls {

    /** The distance that the robot must drive before a pass of the same place counts again, metres. */
    private static final double MIN_LAP = 1.0;

    private final WallCircuit circuit;
    private final int path;
    private final int[] passes;
    private final double[] lastPass;
    /** The walls along the paths that the robot can get to, at the wanted distance and of the body. */
    private final Map<Integer, PassedWall> walls = new HashMap<>();

    private final Map<Integer, PassedWall> bodyWalls = new HashMap<>();
    private final PassedWall firstWall;
    private PassedWall best;

    private double travelled;
    /** How far the robot has driven along the walls, metres. */
    private double followed;

    /** One wall; lengths are in metres. */
    private static final class PassedWall {
        private double length;
        private double passedLength;
        private double weightedPasses;

        void pass(double placeLength, boolean first) {
            passedLength += first ? placeLength : 0;
            weightedPasses += placeLength;
        }

        double share() {
            return length > 0 ? Math.min(1, passedLength / length) : 0;
        }
    }

    /** Creates a record of a circuit for a robot that is on one of its paths. */
    PassedWalls(WallCircuit circuit, int path) {
        this.circuit = circuit;
        this.path = path;
        passes = new int[circuit.size()];
        lastPass = new double[circuit.size()];
        firstWall = new PassedWall();
        best = firstWall;
        walls.put(path, firstWall);
        DisjointSets connected = connectedPaths();
        for (int i = 0; i < passes.length; i++) {
            if (connected.least(circuit.path(i)) == connected.least(path)) {
                addLength(walls, circuit.path(i), circuit.wallLength(i));
                addLength(bodyWalls, circuit.bodyPath(i), circuit.wallLength(i));
            }
        }
    }

    private static void addLength(Map<Integer, PassedWall> walls, int path, double length) {
        walls.computeIfAbsent(path, key -> new PassedWall()).length += length;
    }

    /** Joins the paths that share places, directly or by others. Those of the body follow those of the circuit. */
    private DisjointSets connectedPaths() {
        int count = circuit.size();
        DisjointSets paths = new DisjointSets(2 * count);
        for (int i = 0; i < count; i++) {
            paths.join(circuit.path(i), count + circuit.bodyPath(i));
        }
        return paths;
    }

    /** Returns the length of the longest of the paths, metres. */
    double maxLength() {
        return DoubleStream.concat(
                        walls.keySet().stream().mapToDouble(circuit::length),
                        bodyWalls.keySet().stream().mapToDouble(circuit::bodyLength))
                .max()
                .orElseThrow();
    }

    /** Records that the robot's centre was at a point, after it has driven a distance, metres. */
    void visit(Vector2 centre, double driven) {
        travelled += driven;
        circuit.forEachPassed(centre, this::pass);
    }

    private void pass(int place) {
        PassedWall wall = walls.get(circuit.path(place));
        if (wall == null) {
            return;
        }
        if (passes[place] == 0 || travelled - lastPass[place] > MIN_LAP) {
            for (PassedWall passed : List.of(wall, bodyWalls.get(circuit.bodyPath(place)))) {
                passed.pass(circuit.wallLength(place), passes[place] == 0);
                best = passed.share() > best.share() ? passed : best;
            }
            followed += circuit.spacing();
            passes[place]++;
        }
        lastPass[place] = travelled;
    }

    /** Returns the wall that counts. */
    private PassedWall counted() {
        return followed >= CarryOnMetrics.REQUIRED_SHARE * circuit.length(path) ? best : firstWall;
    }

    /** Returns the share of the wall that was passed, in [0, 1]; empty if the first wall has no length. */
    OptionalDouble share() {
        return firstWall.length > 0 ? OptionalDouble.of(counted().share()) : OptionalDouble.empty();
    }

    /** Returns how often the wall was passed, on average over its length; empty if the first wall has no length. */
    OptionalDouble laps() {
        PassedWall counted = counted();
        return firstWall.length > 0
                ? OptionalDouble.of(counted.weightedPasses / counted.length)
                : OptionalDouble.empty();
    }
}
