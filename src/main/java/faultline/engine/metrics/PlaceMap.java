package faultline.engine.metrics;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.CandidateBuffer;
import faultline.world.SpatialIndex;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * The places from which walls can be followed at a distance, as far as they have been asked for: a wall is sampled when
 * a point or a piece of path comes near it. Places near to each other belong to one piece.
 */
final class PlaceMap {

    /** How many places at either end of a run can be near to places of the next run. */
    private static final int SHARED_ENDS = 6;

    private final WallReference walls;
    private final double distance;
    private final double spacing;
    private final double joinDistance;
    private final List<Vector2> circle;
    private final Map<ConvexShape, Integer> numbers;
    /** The runs of each wall, null for those that have not been sampled. */
    private final List<List<PlaceRun>> sampled;

    /** The runs around the ends of sampled walls, by x and y of the end. */
    private final Map<Double, Map<Double, List<PlaceRun>>> corners = new HashMap<>();

    private final Map<Long, List<Place>> cells = new HashMap<>();
    private final Set<PlaceRun> surveyed = new HashSet<>();

    /** A free place. */
    private record Place(PlaceRun run, int index, Vector2 position) {}

    PlaceMap(WallReference walls, double distance, double spacing, double joinDistance) {
        this.walls = walls;
        this.distance = distance;
        this.spacing = spacing;
        this.joinDistance = joinDistance;
        this.circle = PlaceRow.circle(distance, spacing);
        SpatialIndex all = walls.walls();
        sampled = new ArrayList<>(Collections.nCopies(all.size(), null));
        numbers = new IdentityHashMap<>(all.size());
        for (int i = 0; i < all.size(); i++) {
            numbers.put(all.shape(i), i);
        }
    }

    /** Samples the walls that have places within a radius of a point. */
    void sampleNear(Vector2 point, double radius) {
        CandidateBuffer near = walls.findNear(point, distance + radius);
        List<Integer> found = new ArrayList<>();
        for (int i = 0; i < near.size(); i++) {
            if (near.shape(i).distanceTo(point.x(), point.y()) <= distance + radius) {
                found.add(numbers.get(near.shape(i)));
            }
        }
        found.forEach(this::sample);
    }

    private void sample(int number) {
        if (sampled.get(number) != null) {
            return;
        }
        ConvexShape wall = walls.walls().shape(number);
        List<PlaceRun> runs = new ArrayList<>();
        for (PlaceRow row : PlaceRow.of(wall, distance, spacing, 0, circle)) {
            runs.addAll(row instanceof PlaceRow.Arc arc ? aroundEnd(arc, (Segment) wall) : newRuns(wall, row));
        }
        sampled.set(number, runs);
    }

    /**
     * Returns the runs around an end of a wall, which are those of the neighbour at that end if it has been sampled.
     */
    private List<PlaceRun> aroundEnd(PlaceRow.Arc arc, Segment wall) {
        Map<Double, List<PlaceRun>> above = corners.computeIfAbsent(arc.corner().x(), x -> new HashMap<>(2));
        List<PlaceRun> known = above.get(arc.corner().y());
        if (known == null) {
            List<PlaceRun> runs = newRuns(wall, outside(arc, wall));
            above.put(arc.corner().y(), runs);
            return runs;
        }
        return known.stream().map(run -> run.ofNeighbour(arc.firstRank())).toList();
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

    private List<PlaceRun> newRuns(ConvexShape wall, PlaceRow row) {
        List<PlaceRun> runs = new ArrayList<>();
        for (int from = 0; from < row.size(); from += PlaceRun.LONG) {
            addRuns(wall, row, from, Math.min(from + PlaceRun.LONG, row.size()), runs);
        }
        runs.forEach(this::addToCells);
        return runs;
    }

    /** Adds a part of a row: as one run if that is alone, else as several. */
    private void addRuns(ConvexShape wall, PlaceRow row, int from, int end, List<PlaceRun> runs) {
        PlaceRun all = run(wall, row, from, end);
        if (all.isAlone() || end - from <= PlaceRun.SHORT) {
            runs.add(all);
            return;
        }
        for (int next = from; next < end; next += PlaceRun.SHORT) {
            runs.add(run(wall, row, next, Math.min(next + PlaceRun.SHORT, end)));
        }
    }

    private PlaceRun run(ConvexShape wall, PlaceRow row, int from, int end) {
        PlaceRun run = new PlaceRun(row, from, end, joinDistance);
        int shared = 2 * distance > joinDistance ? row.shared(joinDistance) : row.size();
        CandidateBuffer near = walls.findNear(run.centre(), run.radius() + distance + joinDistance);
        run.occupy(wall, near, distance, shared);
        return run;
    }

    private void addToCells(PlaceRun run) {
        for (int i = 0; i < run.size(); i++) {
            if (run.isFree(i) && (!run.isAlone() || isNearEnd(run, i))) {
                Place place = new Place(run, i, run.place(i));
                cells.computeIfAbsent(CellKey.of(place.position, joinDistance), key -> new ArrayList<>(4))
                        .add(place);
            }
        }
    }

    private static boolean isNearEnd(PlaceRun run, int index) {
        return index < SHARED_ENDS || index >= run.size() - SHARED_ENDS;
    }

    /** Gives a place, and all that are connected to it, the number of a piece. */
    void fill(PlaceRun run, int index, int piece) {
        Deque<Place> open = new ArrayDeque<>();
        reach(new Place(run, index, run.place(index)), piece, open);
        while (!open.isEmpty()) {
            Place place = open.pop();
            if (!place.run.isAlone() && surveyed.add(place.run)) {
                sampleNear(place.run.centre(), place.run.radius() + joinDistance);
            }
            long column = CellKey.index(place.position.x(), joinDistance);
            long row = CellKey.index(place.position.y(), joinDistance);
            for (int dx = -1; dx <= 1; dx++) {
                for (int dy = -1; dy <= 1; dy++) {
                    for (Place other : cells.getOrDefault(CellKey.of(column + dx, row + dy), List.of())) {
                        if (other.run.piece(other.index) == PlaceRun.NO_PIECE
                                && other.position.distanceTo(place.position) <= joinDistance) {
                            reach(other, piece, open);
                        }
                    }
                }
            }
        }
    }

    /** Numbers a place, or all places of a run alone, and adds those that have neighbours to a list. */
    private static void reach(Place place, int piece, Deque<Place> open) {
        place.run.setPiece(place.index, piece);
        if (!place.run.isAlone()) {
            open.push(place);
            return;
        }
        for (int i = 0; i < place.run.size(); i++) {
            if (isNearEnd(place.run, i)) {
                open.push(new Place(place.run, i, place.run.place(i)));
            }
        }
    }

    /** Returns the runs of each wall that has been sampled so far, in the order of the walls. */
    List<List<PlaceRun>> runs() {
        return sampled.stream().filter(Objects::nonNull).toList();
    }
}
