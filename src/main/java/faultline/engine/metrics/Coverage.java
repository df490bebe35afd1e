package faultline.engine.metrics;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Supplier;

/**
 * The followed share of the wall. The robot's offset path, that is, all places at the wanted distance from a wall and
 * nowhere nearer to any, consists of connected pieces; the piece of which the robot passed most is the wall that it
 * followed. A place is passed if the robot's centre was within {@link #TOLERANCE} of it.
 */
final class Coverage implements CoverageMeter {

    /** The greatest distance at which the robot passes a place, metres. */
    static final double TOLERANCE = 0.05;

    /** The robot's path is looked at in one point of each cell of this side, metres. */
    private static final double CELL = 0.01;

    /** Points nearer than this to the last one are skipped, metres. */
    private static final double MIN_STEP = 0.002;

    private final Supplier<WallCircuit> circuits;
    private final Set<Long> visitedCells = new HashSet<>();
    /** Visited points whose places are not yet marked as passed. */
    private final List<Vector2> pending = new ArrayList<>();

    private Vector2 last = new Vector2(Double.POSITIVE_INFINITY, 0);
    private WallCircuit circuit = WallCircuit.empty();
    private boolean[] passed = new boolean[0];
    private double share = Double.NaN;

    /**
     * Creates a record of passing walls; the circuit is computed when it is first needed, because that takes long in
     * large worlds.
     */
    Coverage(Supplier<WallCircuit> circuits) {
        this.circuits = circuits;
    }

    @Override
    public void visit(Vector2 centre) {
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

    @Override
    public OptionalDouble share() {
        if (!pending.isEmpty()) {
            if (passed.length == 0) {
                circuit = circuits.get();
                passed = new boolean[circuit.size()];
            }
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
            length[circuit.way(i)] += circuit.wallLength(i);
            passedLength[circuit.way(i)] += passed[i] ? circuit.wallLength(i) : 0;
        }
        int most = 0;
        for (int i = 1; i < passed.length; i++) {
            most = passedLength[i] > passedLength[most] ? i : most;
        }
        return passed.length == 0 || passedLength[most] == 0 ? Double.NaN : passedLength[most] / length[most];
    }
}
