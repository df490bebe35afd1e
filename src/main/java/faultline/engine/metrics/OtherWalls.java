package faultline.engine.metrics;

import faultline.engine.walls.BodyPaths;
import faultline.engine.walls.DisjointSets;
import faultline.engine.walls.WallCircuit;
import faultline.geometry.Vector2;

/**
 * The walls that count besides the first one if the robot has not passed enough of that in time. A passage can be too
 * narrow for the wanted distance on both sides although the robot's body has room in it. The robot may turn back there,
 * and then follows a path at the wanted distance; or it passes, and then follows one of the {@link BodyPaths}. A wall
 * counts if the robot can get to its path from the first one by such paths, and has driven along it as far as
 * {@link CarryOnMetrics#REQUIRED_SHARE} of the first path. What it drives back is taken off.
 */
final class OtherWalls {

    /** The distance that the robot must drive before a pass of the same place counts again, metres. */
    static final double MIN_LAP = 1.0;

    private static final int NONE = -1;

    private final WallCircuit circuit;
    private final BodyPaths bodyPaths;
    private final int[] passes;
    private final double[] lastPass;
    /** The walls along the paths that the robot can get to, by the first place of the path; null for other paths. */
    private final OtherWall[] walls;

    private final OtherWall[] bodyWalls;
    /** How far the robot must drive along a wall until it counts, metres. */
    private final double required;

    private double maxLength;
    private double travelled;
    /**
     * The wall that counts and of which the robot has passed the greatest share; one without length if there is none.
     */
    private OtherWall best = new OtherWall();
    /** The nearest of the places that the robot passes now; the robot drives along its walls. */
    private int nearest;

    /** Creates a record of a circuit for a robot that is first on one of its paths. */
    OtherWalls(WallCircuit circuit, int path) {
        this.circuit = circuit;
        bodyPaths = circuit.bodyPaths();
        int count = circuit.size();
        passes = new int[count];
        lastPass = new double[count];
        walls = new OtherWall[count];
        bodyWalls = new OtherWall[count];
        required = CarryOnMetrics.REQUIRED_SHARE * circuit.length(path);
        DisjointSets connected = connected();
        for (int i = 0; i < count; i++) {
            if (connected.least(i) == connected.least(path)) {
                addLength(walls, circuit.path(i), circuit.wallLength(i));
                addLength(bodyWalls, bodyPaths.path(i), circuit.wallLength(i));
                maxLength = Math.max(maxLength, Math.max(circuit.length(i), bodyPaths.length(i)));
            }
        }
    }

    /** Joins the places of each path. */
    private DisjointSets connected() {
        DisjointSets places = new DisjointSets(circuit.size());
        for (int i = 0; i < circuit.size(); i++) {
            places.join(i, circuit.path(i));
            places.join(i, bodyPaths.path(i));
        }
        return places;
    }

    private static void addLength(OtherWall[] walls, int path, double length) {
        if (walls[path] == null) {
            walls[path] = new OtherWall();
        }
        walls[path].length += length;
    }

    /** Returns the length of the longest of the paths, metres. */
    double maxLength() {
        return maxLength;
    }

    /** Records that the robot's centre has moved from one point to another. */
    void visit(Vector2 from, Vector2 to) {
        travelled += to.distanceTo(from);
        nearest = NONE;
        circuit.forEachPassed(to, place -> pass(place, to));
        if (nearest != NONE) {
            double ahead = circuit.ahead(nearest, from, to);
            drive(walls[circuit.path(nearest)], ahead);
            drive(bodyWalls[bodyPaths.path(nearest)], ahead);
        }
    }

    private void pass(int place, Vector2 centre) {
        OtherWall wall = walls[circuit.path(place)];
        if (wall == null) {
            return;
        }
        if (passes[place] == 0 || travelled - lastPass[place] > MIN_LAP) {
            wall.pass(circuit.wallLength(place), passes[place] == 0);
            bodyWalls[bodyPaths.path(place)].pass(circuit.wallLength(place), passes[place] == 0);
            passes[place]++;
        }
        lastPass[place] = travelled;
        if (nearest == NONE || circuit.distance(place, centre) < circuit.distance(nearest, centre)) {
            nearest = place;
        }
    }

    private void drive(OtherWall wall, double ahead) {
        wall.ahead += ahead;
        wall.counts |= Math.abs(wall.ahead) >= required;
        best = wall.counts && wall.share() > best.share() ? wall : best;
    }

    /** Returns the share that was passed of the wall that counts, in [0, 1]; 0 if none does. */
    double share() {
        return best.share();
    }

    /** Returns how often that wall was passed, on average over its length. */
    double laps() {
        return best.weightedPasses / best.length;
    }

    /** One wall; lengths are in metres. */
    private static final class OtherWall {
        private double length;
        private double passedLength;
        private double weightedPasses;
        /** How far the robot has driven along it with the wall on its left, less what it has driven back. */
        private double ahead;

        /** Whether the robot has driven far enough along it. */
        private boolean counts;

        void pass(double placeLength, boolean first) {
            passedLength += first ? placeLength : 0;
            weightedPasses += placeLength;
        }

        double share() {
            return length > 0 ? Math.min(1, passedLength / length) : 0;
        }
    }
}
