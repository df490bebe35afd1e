package faultline.engine.walls;

import faultline.engine.Simulation;
import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.world.SpatialIndex;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The walls of a world at the start, as ground truth for wall followers: what can be followed at a distance. Moving
 * obstacles do not count as walls. Confined to one thread.
 */
public final class WallReference {

    /** A bound of the error of a distance, metres. */
    static final double ROUNDING = 1e-9;

    /** The maximum number of places of a world, because every place takes about 140 bytes. */
    public static final int MAX_PLACES = 2_000_000;

    private final WorldSpec world;
    /** Null until it is needed, because creating it takes a long time in large worlds. */
    private SpatialIndex index;
    /** Not a number until it is needed. */
    private double length = Double.NaN;
    /** Null until it is needed. */
    private WallTree tree;

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

    /** Returns the walls for the searches of places. */
    WallTree tree() {
        if (tree == null) {
            tree = new WallTree(walls());
        }
        return tree;
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
        // Blocks without free places take no memory.
        PlaceFinder finder = new PlaceFinder(tree(), distance, Double.POSITIVE_INFINITY, Integer.MAX_VALUE);
        for (int i = 0; i < walls().size(); i++) {
            ConvexShape wall = walls().shape(i);
            List<Ranked> free = new ArrayList<>();
            for (PlaceRow row : PlaceRow.of(wall, distance, spacing, reach, circle)) {
                PlaceRow part = row instanceof PlaceRow.Arc arc ? finder.outside(arc, (Segment) wall) : row;
                finder.forEachFree(wall, part, block -> addFree(block, MAX_PLACES - places.size(), distance, free));
            }
            free.sort(Comparator.comparingLong(Ranked::rank));
            free.forEach(place -> places.add(place.sample));
        }
        return places;
    }

    /** A place with its position in the order of all places of its wall. */
    private record Ranked(long rank, WallSample sample) {}

    private static void addFree(PlaceBlock block, int max, double distance, List<Ranked> free) {
        for (int i = 0; i < block.size(); i++) {
            if (block.isFree(i)) {
                if (free.size() == max) {
                    throw new PathTooLongException(distance, MAX_PLACES);
                }
                free.add(new Ranked(
                        block.rank(i), new WallSample(block.place(i), block.offset(i), block.wallLength(i))));
            }
        }
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
     * @param offset the way from the nearest point of the wall to there, metres
     * @param wallLength the length of the piece of wall, metres; 0 for a corner, which only joins two walls
     */
    public record WallSample(Vector2 position, Vector2 offset, double wallLength) {

        /** Returns the point at a distance from the wall, metres, on the way to the position. */
        Vector2 atDistance(double distance) {
            return position.plus(offset.times(distance / offset.length() - 1));
        }
    }
}
