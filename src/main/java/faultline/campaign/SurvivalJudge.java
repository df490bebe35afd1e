package faultline.campaign;

import faultline.engine.metrics.WallReference;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Judges from ground truth whether a robot carried on after a moment: how much of the wall that it was at then it has
 * passed near the wanted path since.
 */
public final class SurvivalJudge {

    /** How far from the wanted path the robot may pass, metres. */
    public static final double BAND = 0.15;

    /** The share of the wall that must be passed. */
    public static final double SHARE = 0.80;

    private static final double SPACING = 0.03;
    private static final double JOINED = 0.065;

    private final List<WallReference.Sample> samples;
    private final int[] pieces;
    private final boolean[] passed;
    private final Map<Long, List<Integer>> cells = new HashMap<>();
    private Vector2 last = new Vector2(Double.POSITIVE_INFINITY, 0);

    /**
     * Creates a judge.
     *
     * @param world before anything moves
     * @param offset from the walls to the wanted path of the robot's centre, metres
     */
    public SurvivalJudge(WorldSpec world, double offset) {
        samples = new WallReference(withPolygons(world)).samples(offset, SPACING);
        passed = new boolean[samples.size()];
        for (int i = 0; i < passed.length; i++) {
            cells.computeIfAbsent(cell(samples.get(i).position(), 0, 0), key -> new ArrayList<>())
                    .add(i);
        }
        pieces = pieces();
    }

    /** Poles are judged as octagons, whose corners are sampled as densely as walls. */
    private static WorldSpec withPolygons(WorldSpec world) {
        List<Obstacle> obstacles = new ArrayList<>();
        for (Obstacle obstacle : world.obstacles()) {
            obstacles.add(
                    obstacle.shape() instanceof ObstacleShape.Circle circle
                            ? new Obstacle(obstacle.id(), octagon(circle.radius()), obstacle.pose(), obstacle.motion())
                            : obstacle);
        }
        return new WorldSpec(world.width(), world.height(), world.enclosed(), world.maxMoving(), obstacles);
    }

    private static ObstacleShape octagon(double radius) {
        List<Vector2> points = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            points.add(Vector2.direction(i * StrictMath.PI / 4).times(radius));
        }
        return new ObstacleShape.Polygon(points);
    }

    private static long cell(Vector2 point, int dx, int dy) {
        long column = (long) Math.floor(point.x() / BAND) + dx;
        long row = (long) Math.floor(point.y() / BAND) + dy;
        return column << 32 ^ row & 0xFFFF_FFFFL;
    }

    private interface Visitor {
        void visit(int sample);
    }

    private void near(Vector2 point, double radius, Visitor visitor) {
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                for (int i : cells.getOrDefault(cell(point, dx, dy), List.of())) {
                    if (samples.get(i).position().distanceTo(point) <= radius) {
                        visitor.visit(i);
                    }
                }
            }
        }
    }

    private int[] pieces() {
        int[] piece = new int[samples.size()];
        java.util.Arrays.fill(piece, -1);
        for (int i = 0; i < piece.length; i++) {
            if (piece[i] < 0) {
                List<Integer> open = new ArrayList<>(List.of(i));
                int name = i;
                piece[i] = name;
                while (!open.isEmpty()) {
                    int next = open.remove(open.size() - 1);
                    near(samples.get(next).position(), JOINED, other -> {
                        if (piece[other] < 0) {
                            piece[other] = name;
                            open.add(other);
                        }
                    });
                }
            }
        }
        return piece;
    }

    /**
     * Notes where the robot's centre is.
     *
     * @param centre metres
     */
    public void visit(Vector2 centre) {
        if (centre.distanceTo(last) >= 0.01) {
            last = centre;
            near(centre, BAND, i -> passed[i] = true);
        }
    }

    /**
     * Returns the piece of wall that a robot is at.
     *
     * @param centre of the robot, metres
     * @return its number, -1 if there is no wall
     */
    public int pieceAt(Vector2 centre) {
        int best = -1;
        for (int i = 0; i < samples.size(); i++) {
            if (best < 0
                    || samples.get(i).position().distanceTo(centre)
                            < samples.get(best).position().distanceTo(centre)) {
                best = i;
            }
        }
        return best < 0 ? -1 : pieces[best];
    }

    /**
     * Returns the share of a piece of wall that was passed.
     *
     * @param piece its number
     * @return in [0, 1]
     */
    public double share(int piece) {
        double all = 0;
        double some = 0;
        for (int i = 0; i < passed.length; i++) {
            if (pieces[i] == piece) {
                all += samples.get(i).wallLength();
                some += passed[i] ? samples.get(i).wallLength() : 0;
            }
        }
        return all == 0 ? 0 : some / all;
    }

    /** Returns the piece of which most was passed, -1 if none. */
    public int mostPassed() {
        int best = -1;
        double most = 0;
        for (int i = 0; i < passed.length; i++) {
            if (passed[i] && share(pieces[i]) > most) {
                most = share(pieces[i]);
                best = pieces[i];
            }
        }
        return best;
    }

    /**
     * Returns the length of the wanted path along a piece of wall, in which corners count with their arcs.
     *
     * @param piece its number
     * @return metres
     */
    public double length(int piece) {
        double length = 0;
        for (int i = 0; i < pieces.length; i++) {
            if (pieces[i] == piece) {
                length += samples.get(i).wallLength() > 0 ? samples.get(i).wallLength() : SPACING;
            }
        }
        return length;
    }
}
