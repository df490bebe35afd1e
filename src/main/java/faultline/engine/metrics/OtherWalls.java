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

    private static final int NONE = -1;

    private final WallCircuit circuit;
    private final BodyPaths bodyPaths;
    private final PlacePasses passes;
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
    private PassedWall best = new PassedWall();
    /** The nearest of the places that the robot passes now; the robot drives along its walls. */
    private int nearest;

    /** Creates a record of a circuit for a robot that is first on one of its paths. */
    OtherWalls(WallCircuit circuit, int path) {
        this.circuit = circuit;
        bodyPaths = circuit.bodyPaths();
        int count = circuit.size();
        passes = new PlacePasses(count);
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
        walls[path].passed.addLength(length);
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
        int pass = passes.record(place, travelled);
        if (pass > 0) {
            wall.passed.pass(circuit.wallLength(place), pass == 1);
            bodyWalls[bodyPaths.path(place)].passed.pass(circuit.wallLength(place), pass == 1);
        }
        if (nearest == NONE || circuit.distance(place, centre) < circuit.distance(nearest, centre)) {
            nearest = place;
        }
    }

    private void drive(OtherWall wall, double ahead) {
        wall.ahead += ahead;
        wall.counts |= Math.abs(wall.ahead) >= required;
        best = wall.counts && wall.passed.share() > best.share() ? wall.passed : best;
    }

    /**
     * Returns the wall that counts and of which the robot has passed the greatest share; one without length if none.
     */
    PassedWall best() {
        return best;
    }

    /** A wall, and how far the robot has driven along it. */
    private static final class OtherWall {
        private final PassedWall passed = new PassedWall();
        /** The distance driven with the wall on the left, less what the robot has driven back, metres. */
        private double ahead;

        /** Whether the robot has driven far enough along it. */
        private boolean counts;
    }
}
