package faultline.engine.walls;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;

/** Measures the coverage by sampling all walls: the reference implementation of {@link Coverage}. */
final class EagerCoverage {

    /** The robot's path is looked at in one point of each cell of this side, metres. */
    private static final double CELL = 0.01;

    /** Points nearer than this to the last one are skipped, metres. */
    private static final double MIN_STEP = 0.002;

    private final Set<Long> visitedCells = new HashSet<>();
    /** Visited points whose places are not yet marked as passed. */
    private final List<Vector2> pending = new ArrayList<>();

    private Vector2 last = new Vector2(Double.POSITIVE_INFINITY, 0);
    private final WallCircuit circuit;
    private final boolean[] passed;
    private double share = Double.NaN;

    EagerCoverage(WallReference walls, double distance) {
        circuit =
                new WallCircuit(BruteForceSamples.of(walls, distance, 0.01, 0, 0.025), 0.01, 0.025, Coverage.TOLERANCE);
        passed = new boolean[circuit.size()];
    }

    void visit(Vector2 centre) {
        if (centre.distanceTo(last) >= MIN_STEP) {
            if (visitedCells.add(cell(centre))) {
                pending.add(centre);
            }
            last = centre;
        }
    }

    private static long cell(Vector2 centre) {
        long column = (long) Math.floor(centre.x() / CELL);
        long row = (long) Math.floor(centre.y() / CELL);
        return column << 32 ^ row & 0xFFFF_FFFFL;
    }

    OptionalDouble share() {
        if (!pending.isEmpty()) {
            pending.forEach(point -> circuit.forEachPassed(point, place -> passed[place] = true));
            pending.clear();
            share = computeShare();
        }
        return Double.isNaN(share) ? OptionalDouble.empty() : OptionalDouble.of(share);
    }

    private double computeShare() {
        double[] passedLength = new double[passed.length];
        double[] length = new double[passed.length];
        for (int i = 0; i < passed.length; i++) {
            length[circuit.path(i)] += circuit.wallLength(i);
            passedLength[circuit.path(i)] += passed[i] ? circuit.wallLength(i) : 0;
        }
        int most = 0;
        for (int i = 1; i < passed.length; i++) {
            most = passedLength[i] > passedLength[most] ? i : most;
        }
        return passed.length == 0 || passedLength[most] == 0 ? Double.NaN : passedLength[most] / length[most];
    }
}
