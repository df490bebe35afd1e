package faultline.engine.walls;

import faultline.geometry.Vector2;
import java.util.List;
import java.util.OptionalDouble;

/**
 * The followed share of the wall. The offset path consists of all places at the wanted distance from a wall and not
 * nearer to any other wall. It has connected pieces; the piece of which the robot passed most is the wall that it
 * followed. A place is passed if the robot's centre was within {@link #TOLERANCE} of it. Walls are sampled only where
 * the robot was, and where they are connected to such walls. If there are too many places, there is no share.
 */
public final class Coverage {

    /** The greatest distance at which the robot passes a place, metres. */
    public static final double TOLERANCE = 0.05;

    /**
     * The greatest distance between two points of the robot's path that are looked at, metres; between points farther
     * apart a place could be missed.
     */
    public static final double MAX_STEP = TOLERANCE / 2;

    /**
     * The maximum number of places on the path along the wall, which limits the memory that they take. It is twice that
     * of a campaign, whose places are twice as far apart.
     */
    public static final int MAX_PATH_PLACES = 2 * WallReference.MAX_PLACES;

    /** Samples along the walls are this far apart, metres. */
    private static final double SPACING = 0.01;

    /** Places nearer to each other than this are joined, metres. */
    private static final double JOIN_DISTANCE = 0.025;

    /** Points of the path nearer to the last one than this are skipped, metres. */
    private static final double MIN_STEP = 0.002;

    /** The side of the squares by which walls are first compared with the path, metres. */
    private static final double AREA_SIZE = 1;

    private final WallReference walls;
    private final double distance;
    private final int maxPlaces;
    /** The cells in which a visited point lies. */
    private final CellNumbers visited = new CellNumbers();
    /** The points visited since the share was last computed, and the squares around. */
    private final PointCells pending = new PointCells(TOLERANCE + WallReference.ROUNDING);

    private final CellNumbers pendingAreas = new CellNumbers();
    private Vector2 last = new Vector2(Double.POSITIVE_INFINITY, 0);
    /** Created when it is first needed. */
    private PlaceMap places;

    private int pieces;
    private double share = Double.NaN;
    private boolean pathTooLong;

    /**
     * Creates a record of passing walls.
     *
     * @param walls the walls
     * @param distance the distance of the walls from the robot's centre, metres
     */
    public Coverage(WallReference walls, double distance) {
        this(walls, distance, MAX_PATH_PLACES);
    }

    /**
     * Creates a record with another maximum number of places.
     *
     * @param walls the walls
     * @param distance the distance of the walls from the robot's centre, metres
     * @param maxPlaces the maximum number of places on the path along the walls
     */
    public Coverage(WallReference walls, double distance, int maxPlaces) {
        this.walls = walls;
        this.distance = distance;
        this.maxPlaces = maxPlaces;
    }

    /**
     * Records that the robot's centre was at a point; one point a square centimetre is kept.
     *
     * @param centre the point
     */
    public void visit(Vector2 centre) {
        if (!pathTooLong && centre.distanceTo(last) >= MIN_STEP) {
            long cell = CellKey.of(centre, SPACING);
            if (!visited.contains(cell)) {
                visited.put(cell, 0);
                pending.add(centre);
                pendingAreas.put(CellKey.of(centre, AREA_SIZE), 0);
            }
            last = centre;
        }
    }

    /** {@return whether no point has been recorded} */
    public boolean isEmpty() {
        return visited.isEmpty();
    }

    /** {@return whether the share is not known, because there are too many places} */
    public boolean isPathTooLong() {
        return pathTooLong;
    }

    /**
     * {@return the share so far, in [0, 1]; empty if nothing was passed, or if there are too many places} May be called
     * repeatedly during a run.
     */
    public OptionalDouble share() {
        if (!pathTooLong && !pending.points().isEmpty()) {
            share = computeShare();
            pending.clear();
            pendingAreas.clear();
        }
        return Double.isNaN(share) ? OptionalDouble.empty() : OptionalDouble.of(share);
    }

    private double computeShare() {
        places = places == null ? new PlaceMap(walls, distance, SPACING, JOIN_DISTANCE, maxPlaces) : places;
        try {
            sampleNearPath();
            places.blocks().forEach(blocks -> blocks.forEach(this::markPassed));
            return shareOfMostPassed();
        } catch (WallReference.PathTooLongException e) {
            pathTooLong = true;
            places = null;
            return Double.NaN;
        }
    }

    /** Samples the walls near the pending points; points nearer to the last one than the tolerance need no sampling. */
    private void sampleNearPath() {
        Vector2 from = null;
        for (Vector2 point : pending.points()) {
            if (from == null || point.distanceTo(from) > TOLERANCE) {
                places.sampleNear(point, 2 * TOLERANCE + WallReference.ROUNDING);
                from = point;
            }
        }
    }

    private void markPassed(PlaceBlock block) {
        for (int i = nextNearPath(block, 0); i < block.size(); i = nextNearPath(block, i + 1)) {
            if (block.isFree(i) && !block.isPassed(i) && pending.isNear(block.place(i), TOLERANCE)) {
                block.setPassed(i);
                if (block.piece(i) == PlaceBlock.NO_PIECE) {
                    places.fill(block, i, pieces++);
                }
            }
        }
    }

    /** Returns the passed share of the piece of which most was passed; of equals, of the one that begins first. */
    private double shareOfMostPassed() {
        PieceLengths lengths = new PieceLengths(pieces);
        int wall = 0;
        for (List<PlaceBlock> blocks : places.blocks()) {
            for (PlaceBlock block : blocks) {
                lengths.add(block, wall);
            }
            wall++;
        }
        return lengths.shareOfMostPassed();
    }

    /** Returns the first place of a block, from an index on, that may have been passed; if there is none, the size. */
    private int nextNearPath(PlaceBlock block, int from) {
        int i = from;
        while (i < block.size() && i % PlaceBlock.SHORT == 0 && !isNearPath(block, i)) {
            i += PlaceBlock.SHORT;
        }
        return Math.min(i, block.size());
    }

    /** Returns whether the robot has been near one of some places, the first of which is given, since the last call. */
    private boolean isNearPath(PlaceBlock block, int first) {
        Vector2 middle = block.place(Math.min(first + PlaceBlock.SHORT / 2, block.size() - 1));
        double radius = block.isAlone() ? PlaceBlock.SHORT * JOIN_DISTANCE / 2 : 2 * block.radius();
        if (radius + TOLERANCE > AREA_SIZE) {
            return true;
        }
        long column = CellKey.index(middle.x(), AREA_SIZE);
        long row = CellKey.index(middle.y(), AREA_SIZE);
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                if (pendingAreas.contains(CellKey.of(column + dx, row + dy))) {
                    return true;
                }
            }
        }
        return false;
    }
}
