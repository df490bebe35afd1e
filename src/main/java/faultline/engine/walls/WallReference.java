package faultline.engine.walls;

import faultline.engine.Simulation;
import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.world.CandidateBuffer;
import faultline.world.SpatialIndex;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The walls of a world at the start, as ground truth for wall followers: what can be followed at a distance. Moving
 * obstacles do not count as walls. Confined to one thread.
 */
public final class WallReference {

    /** A bound of the error of a distance, metres. */
    static final double ROUNDING = 1e-9;

    /** The maximum number of places of a world, because every place takes about 130 bytes. */
    public static final int MAX_PLACES = 2_000_000;

    private final WorldSpec world;
    private final CandidateBuffer candidates = new CandidateBuffer();
    /** Null until it is needed, because creating it takes a long time in large worlds. */
    private SpatialIndex index;
    /** Not a number until it is needed. */
    private double length = Double.NaN;
    /** The wall that was nearer to the last place that is not free: it often is nearer to the next place too. */
    private ConvexShape lastNearer;

    /**
     * Creates the reference of a world at its start.
     *
     * @param world the world
     */
    public WallReference(WorldSpec world) {
        this.world = world;
    }

    /**
     * Uses the index of a simulation if it is of the same world and no index exists yet.
     *
     * @param simulation the simulation
     */
    public void share(Simulation simulation) {
        if (index == null && simulation.setup().world() == world) {
            index = simulation.startIndex();
        }
    }

    /** {@return the index of the walls} */
    public SpatialIndex walls() {
        if (index == null) {
            index = SpatialIndex.ofStaticShapes(world);
        }
        return index;
    }

    /** {@return the number of shapes that the walls consist of} */
    public int size() {
        return walls().size();
    }

    /** {@return the length of all walls, metres; of an ellipse that of a circle around it} */
    public double length() {
        if (Double.isNaN(length)) {
            length = IntStream.range(0, size())
                    .mapToObj(walls()::shape)
                    .mapToDouble(wall -> wall.boundingRadius() * 2 * (wall instanceof Segment ? 1 : StrictMath.PI))
                    .sum();
        }
        return length;
    }

    /**
     * {@return the places from which walls can be followed, in the order of the walls} They are spaced along the
     * robot's path rather than along the walls, so that places around a pole are not farther apart than others.
     *
     * @param distance the distance from the wall to the robot's centre, metres
     * @param spacing the spacing of the samples along the path, metres
     * @throws PathTooLongException if there are too many places
     */
    public List<WallSample> samplesAlongPath(double distance, double spacing) {
        return samples(distance, spacing, distance);
    }

    /**
     * {@return the points at a distance from a wall and not nearer to any other wall, in the order of the walls}
     *
     * @param distance the distance from the wall, metres
     * @param spacing the spacing of the points, metres
     * @param reach where they are spaced: along the path of the robot if it is its distance from the walls, and along
     *     the walls if it is 0, metres
     * @throws PathTooLongException if there are too many places
     */
    public List<WallSample> samples(double distance, double spacing, double reach) {
        List<WallSample> places = new ArrayList<>();
        if (walls().size() == 0) {
            return places;
        }
        // The path around all walls is at least as long as a circle at the distance.
        if (2 * StrictMath.PI * distance > MAX_PLACES * spacing) {
            throw new PathTooLongException(distance, MAX_PLACES);
        }
        List<Vector2> circle = PlaceRow.circle(distance, spacing);
        for (int i = 0; i < walls().size(); i++) {
            List<PlaceRow> rows = PlaceRow.of(walls().shape(i), distance, spacing, reach, circle);
            boolean bothSides = rows.get(0) instanceof PlaceRow.Side;
            if (bothSides) {
                addInTurn(rows.get(0), rows.get(1), distance, places);
            }
            for (PlaceRow row : rows.subList(bothSides ? 2 : 0, rows.size())) {
                for (int place = 0; place < row.size(); place++) {
                    addIfFree(row, place, distance, places);
                }
            }
        }
        return places;
    }

    private void addInTurn(PlaceRow left, PlaceRow right, double distance, List<WallSample> places) {
        for (int place = 0; place < left.size(); place++) {
            addIfFree(left, place, distance, places);
            addIfFree(right, place, distance, places);
        }
    }

    private void addIfFree(PlaceRow row, int index, double distance, List<WallSample> places) {
        Vector2 place = row.place(index);
        if (lastNearer != null && nearness(lastNearer, place, distance) > 0) {
            return;
        }
        CandidateBuffer near = findNear(place, distance);
        for (int i = 0; i < near.size(); i++) {
            if (nearness(near.shape(i), place, distance) > 0) {
                lastNearer = near.shape(i);
                return;
            }
        }
        if (places.size() == MAX_PLACES) {
            throw new PathTooLongException(distance, MAX_PLACES);
        }
        places.add(new WallSample(place, row.wallLength(index)));
    }

    /**
     * Returns by how much a wall is nearer to a place than the places of the walls are, metres; not positive if it is
     * not nearer.
     */
    static double nearness(ConvexShape wall, Vector2 place, double distance) {
        double estimate = nearness(wall.distanceTo(place.x(), place.y()), distance);
        // The nearest point, which creates an object, decides only where rounding could matter.
        return Math.abs(estimate) > ROUNDING
                ? estimate
                : nearness(wall.nearestTo(place).distanceTo(place), distance);
    }

    /** Returns by how much a wall at a distance from a place is nearer than the places of the walls are, metres. */
    static double nearness(double toWall, double distance) {
        return distance * (1 - 1e-6) - toWall;
    }

    /**
     * Returns whether a wall at a distance from a point is nearer than their walls are to all places within a radius.
     */
    static boolean occupiesAround(double toWall, double distance, double radius) {
        return nearness(toWall, distance) - radius > ROUNDING;
    }

    /** Returns the walls near a point, and perhaps others, until the next call. */
    CandidateBuffer findNear(Vector2 point, double radius) {
        candidates.clear();
        walls().findNear(point.x(), point.y(), radius, candidates);
        return candidates;
    }

    /** Thrown if the path along the walls is too long to be sampled. */
    public static final class PathTooLongException extends RuntimeException {

        private static final long serialVersionUID = 1L;

        PathTooLongException(double distance, int maxPlaces) {
            super("the path at a distance of " + DecimalText.format(distance)
                    + " m from the walls has too many places; expected at most " + maxPlaces);
        }
    }

    /**
     * A place from which a piece of wall can be followed.
     *
     * @param position the position of the robot's centre
     * @param wallLength the length of the piece of wall, metres; 0 for a corner, which only joins two walls
     */
    public record WallSample(Vector2 position, double wallLength) {}
}
