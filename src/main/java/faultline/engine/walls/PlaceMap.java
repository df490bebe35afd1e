package faultline.engine.walls;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.CandidateBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
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

    /** The radius of a run, as a share of the join distance: two places of a run are always joined. */
    private static final double RUN_RADIUS = 1 / 32.0;

    private final WallReference walls;
    private final double distance;
    private final double spacing;
    private final double joinDistance;
    private final int maxPlaces;
    /** The number of places that are kept, and of blocks without any. */
    private int size;
    /** The places around the origin; empty until a wall is sampled, because at a great distance they are very many. */
    private List<Vector2> circle = List.of();
    /** The blocks of each wall that has been sampled, by its number. */
    private final Map<Integer, List<PlaceBlock>> blocksByWall = new TreeMap<>();

    private final BitSet sampledWalls = new BitSet();

    /** The blocks around the ends of sampled walls, by x and y of the end. */
    private final Map<Double, Map<Double, List<PlaceBlock>>> corners = new HashMap<>();

    /**
     * The free places. Around a thin ellipse, thousands can be in one cell, so successive ones that are very near to
     * the first of them make a run, and are compared with other places as one.
     */
    private final List<Place> places = new ArrayList<>();

    /** For the first place of each run the first one of the next run in its cell; the last run leads to the first. */
    private int[] next = new int[1024];
    /** The number of places in the run of each first place. */
    private int[] runSizes = new int[1024];
    /** The first places of the runs that belong to a piece as a whole. */
    private final BitSet reachedRuns = new BitSet();
    /** The first place of the last run of each cell. */
    private final CellNumbers cells = new CellNumbers();

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
        this.walls = walls;
        this.distance = distance;
        this.spacing = spacing;
        this.joinDistance = joinDistance;
        this.maxPlaces = maxPlaces;
    }

    /**
     * Samples the walls that have places within a radius of a point, unless a wall occupies all places there.
     *
     * @throws WallReference.PathTooLongException if there are too many places
     */
    void sampleNear(Vector2 point, double radius) {
        CandidateBuffer near = walls.findNear(point, distance + radius);
        List<Integer> found = new ArrayList<>();
        for (int i = 0; i < near.size(); i++) {
            double toWall = near.shape(i).distanceTo(point.x(), point.y());
            if (WallReference.occupiesAround(toWall, distance, radius)) {
                return;
            }
            if (!sampledWalls.get(near.number(i)) && toWall <= distance + radius) {
                found.add(near.number(i));
            }
        }
        found.forEach(this::sample);
    }

    private void sample(int number) {
        sampledWalls.set(number);
        if (2 * StrictMath.PI * distance > maxPlaces * spacing) {
            throw new WallReference.PathTooLongException(distance, maxPlaces);
        }
        circle = circle.isEmpty() ? PlaceRow.circle(distance, spacing) : circle;
        ConvexShape wall = walls.walls().shape(number);
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
            List<PlaceBlock> blocks = newBlocks(wall, outside(arc, wall));
            above.put(arc.corner().y(), blocks);
            return blocks;
        }
        return known.stream().map(block -> block.ofNeighbour(arc.firstRank())).toList();
    }

    /** Returns the part of the arc around an end of a wall that neither it nor a neighbour at that end occupies. */
    private PlaceRow outside(PlaceRow.Arc arc, Segment wall) {
        CandidateBuffer near = walls.findNear(arc.corner(), 0);
        Segment neighbour = wall;
        for (int i = 0; i < near.size(); i++) {
            if (near.shape(i) != wall && near.shape(i) instanceof Segment other && arc.isAtEndOf(other)) {
                neighbour = other;
            }
        }
        return arc.outside(wall, neighbour);
    }

    /** Returns blocks of the places of a row that have free ones. */
    private List<PlaceBlock> newBlocks(ConvexShape wall, PlaceRow row) {
        List<PlaceBlock> blocks = new ArrayList<>();
        for (int from = 0; from < row.size(); from += PlaceBlock.LONG) {
            addBlocks(wall, row, from, Math.min(from + PlaceBlock.LONG, row.size()), blocks);
        }
        return blocks;
    }

    /** Adds a part of a row: as one block if that is alone, else as several. */
    private void addBlocks(ConvexShape wall, PlaceRow row, int from, int end, List<PlaceBlock> blocks) {
        PlaceBlock all = block(wall, row, from, end);
        if (all.isAlone() || end - from <= PlaceBlock.SHORT) {
            addIfFree(all, blocks);
            return;
        }
        for (int next = from; next < end; next += PlaceBlock.SHORT) {
            addIfFree(block(wall, row, next, Math.min(next + PlaceBlock.SHORT, end)), blocks);
        }
    }

    private void addIfFree(PlaceBlock block, List<PlaceBlock> blocks) {
        if (block.hasFree()) {
            blocks.add(block);
            addToCells(block);
        } else {
            count();
        }
    }

    /** Counts a place, or a block without free ones, which takes time. */
    private void count() {
        if (size == maxPlaces) {
            throw new WallReference.PathTooLongException(distance, maxPlaces);
        }
        size++;
    }

    private PlaceBlock block(ConvexShape wall, PlaceRow row, int from, int end) {
        PlaceBlock block = new PlaceBlock(row, from, end, joinDistance);
        int shared = 2 * distance > joinDistance ? row.shared(joinDistance) : row.size();
        CandidateBuffer near = walls.findNear(block.centre(), block.radius() + distance + joinDistance);
        block.occupy(wall, near, distance, shared);
        return block;
    }

    private void addToCells(PlaceBlock block) {
        for (int i = 0; i < block.size(); i++) {
            if (block.isFree(i) && (!block.isAlone() || isNearEnd(block, i))) {
                addToCell(new Place(block, i, block.place(i)));
            }
        }
    }

    private void addToCell(Place place) {
        count();
        int number = places.size();
        places.add(place);
        if (number == next.length) {
            next = Arrays.copyOf(next, 2 * number);
            runSizes = Arrays.copyOf(runSizes, 2 * number);
        }
        long cell = CellKey.of(place.position, joinDistance);
        int last = cells.get(cell);
        if (last != CellNumbers.NONE && continues(last, number)) {
            runSizes[last]++;
            return;
        }
        runSizes[number] = 1;
        next[number] = number;
        if (last != CellNumbers.NONE) {
            next[number] = next[last];
            next[last] = number;
        }
        cells.put(cell, number);
    }

    /** Returns whether a new place is the next one of a run that belongs to no piece yet. */
    private boolean continues(int run, int number) {
        return run + runSizes[run] == number
                && !reachedRuns.get(run)
                && places.get(run).position.distanceTo(places.get(number).position) <= RUN_RADIUS * joinDistance;
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
            long column = CellKey.index(place.position.x(), joinDistance);
            long row = CellKey.index(place.position.y(), joinDistance);
            for (int dx = -1; dx <= 1; dx++) {
                for (int dy = -1; dy <= 1; dy++) {
                    reachCell(cells.get(CellKey.of(column + dx, row + dy)), place.position, piece, open);
                }
            }
        }
    }

    /** Numbers the runs of a cell that are near to a point; the last one of the cell is given, if it has any. */
    private void reachCell(int last, Vector2 point, int piece, Deque<Place> open) {
        if (last == CellNumbers.NONE) {
            return;
        }
        int run = last;
        do {
            run = next[run];
            if (!reachedRuns.get(run) && isNear(run, point)) {
                reachedRuns.set(run);
                reachRun(run, piece, open);
            }
        } while (run != last);
    }

    /** Returns whether a place of a run is near to a point. */
    private boolean isNear(int run, Vector2 point) {
        double toFirst = places.get(run).position.distanceTo(point);
        if (toFirst <= joinDistance) {
            return true;
        }
        boolean near = false;
        if (toFirst <= (1 + 2 * RUN_RADIUS) * joinDistance) {
            for (int i = 1; i < runSizes[run] && !near; i++) {
                near = places.get(run + i).position.distanceTo(point) <= joinDistance;
            }
        }
        return near;
    }

    private void reachRun(int run, int piece, Deque<Place> open) {
        for (int i = 0; i < runSizes[run]; i++) {
            Place place = places.get(run + i);
            if (place.block.piece(place.index) == PlaceBlock.NO_PIECE) {
                reach(place, piece, open);
            }
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
