package faultline.engine.walls;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.SpatialIndex;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * The places from which walls can be followed at a distance, computed on demand: a wall is sampled when a point or a
 * piece of path is near it. Places close to each other belong to one piece.
 */
final class PlaceMap {

    /** The number of places at either end of a block that can be close to places of the next block. */
    private static final int SHARED_ENDS = 6;

    private final SpatialIndex walls;
    private final WallTree tree;
    private final double distance;
    private final double spacing;
    private final double joinDistance;
    private final int maxPlaces;
    private final PlaceFinder finder;
    /** The places around the origin; empty until a wall is sampled, because at a great distance they are very many. */
    private List<Vector2> circle = List.of();
    /** The blocks of each wall that has been sampled, by its number. */
    private final Map<Integer, List<PlaceBlock>> blocksByWall = new TreeMap<>();

    private final WallTree.Untaken unsampled;

    /** The blocks around the ends of sampled walls, by x and y of the end. */
    private final Map<Double, Map<Double, List<PlaceBlock>>> corners = new HashMap<>();

    /** The free places. */
    private final List<Place> places = new ArrayList<>();

    /** Their positions; the runs that belong to a piece as a whole are closed. */
    private final PointRuns runs;

    private final Set<PlaceBlock> surveyed = new HashSet<>();

    /** A free place. */
    private record Place(PlaceBlock block, int index, Vector2 position) {}

    /**
     * Creates a map without places.
     *
     * @param walls the walls
     * @param distance the distance of the places from the walls, metres
     * @param spacing the spacing of the places along the walls, metres
     * @param joinDistance places nearer to each other than this belong to one piece, metres
     * @param maxPlaces the maximum number of places that are kept: those of a block alone are not, except at its ends
     */
    PlaceMap(WallReference walls, double distance, double spacing, double joinDistance, int maxPlaces) {
        this.walls = walls.walls();
        tree = walls.tree();
        this.distance = distance;
        this.spacing = spacing;
        this.joinDistance = joinDistance;
        this.maxPlaces = maxPlaces;
        finder = new PlaceFinder(tree, distance, joinDistance, maxPlaces);
        unsampled = tree.new Untaken();
        runs = new PointRuns(joinDistance);
    }

    /**
     * Samples the walls that have places within a radius of a point, unless a wall occupies all places there.
     *
     * @throws WallReference.PathTooLongException if there are too many places
     */
    void sampleNear(Vector2 point, double radius) {
        int occupier = tree.find(point, distance - radius, i -> {
            double toWall = tree.wall(i).distanceTo(point.x(), point.y());
            return WallReference.occupiesAround(toWall, distance, radius);
        });
        if (occupier == WallTree.NONE) {
            unsampled.take(point, distance + radius).forEach(this::sample);
        }
    }

    private void sample(int number) {
        if (2 * StrictMath.PI * distance > maxPlaces * spacing) {
            throw new WallReference.PathTooLongException(distance, maxPlaces);
        }
        circle = circle.isEmpty() ? PlaceRow.circle(distance, spacing) : circle;
        ConvexShape wall = walls.shape(number);
        List<PlaceBlock> around = new ArrayList<>();
        for (PlaceRow row : PlaceRow.of(wall, distance, spacing, 0, circle)) {
            around.addAll(
                    row instanceof PlaceRow.Arc arc
                            ? aroundEnd(arc, (Segment) wall)
                            : newBlocks(wall, row.joined(joinDistance)));
        }
        blocksByWall.put(number, around);
    }

    /**
     * Returns the blocks around an end of a wall, which are those of the neighbour at that end if it has been sampled.
     */
    private List<PlaceBlock> aroundEnd(PlaceRow.Arc arc, Segment wall) {
        Map<Double, List<PlaceBlock>> above =
                corners.computeIfAbsent(arc.corner().x(), x -> new HashMap<>(2));
        List<PlaceBlock> known = above.get(arc.corner().y());
        if (known == null) {
            List<PlaceBlock> blocks = newBlocks(wall, finder.outside(arc, wall));
            above.put(arc.corner().y(), blocks);
            return blocks;
        }
        return known.stream().map(block -> block.ofNeighbour(arc.firstRank())).toList();
    }

    /** Returns blocks of the places of a row that have free ones. */
    private List<PlaceBlock> newBlocks(ConvexShape wall, PlaceRow row) {
        List<PlaceBlock> blocks = new ArrayList<>();
        finder.forEachFree(wall, row, block -> {
            blocks.add(block);
            addToCells(block);
        });
        checkSize();
        return blocks;
    }

    private void addToCells(PlaceBlock block) {
        for (int i = 0; i < block.size(); i++) {
            if (block.isFree(i) && (!block.isAlone() || isNearEnd(block, i))) {
                addToCell(new Place(block, i, block.place(i)));
            }
        }
    }

    private void addToCell(Place place) {
        places.add(place);
        runs.add(place.position);
        checkSize();
    }

    /** Checks the number of places and of blocks without any, which take time. */
    private void checkSize() {
        if (places.size() + finder.empty() > maxPlaces) {
            throw new WallReference.PathTooLongException(distance, maxPlaces);
        }
    }

    private static boolean isNearEnd(PlaceBlock block, int index) {
        return index < SHARED_ENDS || index >= block.size() - SHARED_ENDS;
    }

    /**
     * Gives a place, and all that are connected to it, the number of a piece.
     *
     * @throws WallReference.PathTooLongException if there are too many places
     */
    void fill(PlaceBlock block, int index, int piece) {
        Deque<Place> open = new ArrayDeque<>();
        reach(new Place(block, index, block.place(index)), piece, open);
        while (!open.isEmpty()) {
            Place place = open.pop();
            if (!place.block.isAlone() && surveyed.add(place.block)) {
                sampleNear(place.block.centre(), place.block.radius() + joinDistance);
            }
            runs.forEachNear(place.position, run -> {
                runs.close(run);
                runs.forEachPoint(run, other -> reach(other, run, piece, open));
            });
        }
    }

    /** Numbers a place of a run. */
    private void reach(int number, int run, int piece, Deque<Place> open) {
        Place place = places.get(number);
        if (place.block.piece(place.index) != PlaceBlock.NO_PIECE) {
            return;
        }
        if (runs.isTwin(number, run)
                && !place.block.isAlone()
                && !places.get(run).block.isAlone()) {
            // The first place of the run has the same neighbours.
            place.block.setPiece(place.index, piece);
        } else {
            reach(place, piece, open);
        }
    }

    /** Numbers a place, or all places of a block alone, and adds those that have neighbours to a list. */
    private static void reach(Place place, int piece, Deque<Place> open) {
        place.block.setPiece(place.index, piece);
        if (!place.block.isAlone()) {
            open.push(place);
            return;
        }
        for (int i = 0; i < place.block.size(); i++) {
            if (isNearEnd(place.block, i)) {
                open.push(new Place(place.block, i, place.block.place(i)));
            }
        }
    }

    /** Returns the blocks of each wall that has been sampled so far, in the order of the walls. */
    List<List<PlaceBlock>> blocks() {
        return List.copyOf(blocksByWall.values());
    }
}
