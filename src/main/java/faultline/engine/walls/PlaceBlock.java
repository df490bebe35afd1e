package faultline.engine.walls;

import faultline.geometry.ConvexShape;
import faultline.geometry.Vector2;
import java.util.Arrays;
import java.util.BitSet;

/**
 * Up to {@link #LONG} neighbouring places of a row. A free place has the number of the piece of path that it belongs
 * to. A block far from all other walls belongs to one piece, and stores no numbers for its places.
 */
final class PlaceBlock {

    /** The number of a free place that does not belong to a piece yet. */
    static final int NO_PIECE = -1;

    private static final int OCCUPIED = -2;

    /** The maximum number of places of a block near other walls. */
    static final int SHORT = 64;

    /** The maximum number of places of a block alone. */
    static final int LONG = 4096;

    private final PlaceRow row;
    private final int from;
    private final int size;
    private final Vector2 centre;
    /** The maximum distance between neighbouring places, metres. */
    private final double step;

    private final double radius;
    private final boolean connected;
    private final BitSet passed;
    private int[] pieces;
    /** The number of free places. */
    private int free;

    /** Creates the block of some places of a row. */
    PlaceBlock(PlaceRow row, int from, int end, double joinDistance) {
        this.row = row;
        this.from = from;
        size = end - from;
        centre = place(size / 2);
        step = row.step(from, end);
        radius = row.radius(from, end);
        connected = step <= joinDistance;
        passed = new BitSet(0);
        pieces = new int[] {NO_PIECE};
        free = size;
    }

    /** Creates a block that shares the places of an arc with another, which is in the same place of another wall. */
    private PlaceBlock(PlaceBlock other, PlaceRow.Arc row) {
        this.row = row;
        from = other.from;
        size = other.size;
        centre = other.centre;
        step = other.step;
        radius = other.radius;
        connected = other.connected;
        passed = other.passed;
        pieces = other.pieces;
        free = other.free;
    }

    /**
     * Returns this block of an arc as one of the other wall that ends at its corner. Both share the state of its
     * places.
     *
     * @param firstRank the rank of the first place around that corner among the places of the other wall
     */
    PlaceBlock ofNeighbour(long firstRank) {
        return new PlaceBlock(this, ((PlaceRow.Arc) row).withFirstRank(firstRank));
    }

    int size() {
        return size;
    }

    /** Returns the index of the place after this block in its row. */
    int end() {
        return from + size;
    }

    Vector2 centre() {
        return centre;
    }

    /** Returns a distance from the centre that no place exceeds, metres. */
    double radius() {
        return radius;
    }

    Vector2 place(int index) {
        return row.place(from + index);
    }

    Vector2 offset(int index) {
        return row.offset(from + index);
    }

    /** Returns the position of a place in the order of all places of its wall. */
    long rank(int index) {
        return row.rank(from + index);
    }

    double wallLength(int index) {
        return row.wallLength(from + index);
    }

    /**
     * Finds which places are free; in a block that is too long and not alone, nothing is found.
     *
     * @param wall the wall of the row
     * @param walls all walls
     * @param distance the distance of the places from the wall, metres
     * @param joinDistance the greatest distance between places that are joined, metres
     * @param shared the number of places at either end of the row that may be near to those of other rows of the wall
     */
    void occupy(ConvexShape wall, WallTree walls, double distance, double joinDistance, int shared) {
        boolean between = connected && from >= shared && end() <= row.size() - shared;
        if (between && !hasOther(wall, walls, radius + distance + joinDistance)) {
            return;
        }
        pieces = new int[size];
        if (size <= SHORT) {
            Arrays.fill(pieces, NO_PIECE);
            occupy(walls, distance);
        }
    }

    @SuppressWarnings("ReferenceEquality") // An equal wall is another one.
    private boolean hasOther(ConvexShape wall, WallTree walls, double reach) {
        int other = walls.find(
                centre,
                reach,
                i -> (walls.wall(i) != wall || walls.hasEqual(i))
                        && walls.wall(i).distanceTo(centre.x(), centre.y()) <= reach + WallReference.ROUNDING);
        return other != WallTree.NONE;
    }

    /** Marks the places that are nearer to some walls than the distance. */
    private void occupy(WallTree walls, double distance) {
        if (isOccupied(walls, distance)) {
            Arrays.fill(pieces, OCCUPIED);
            free = 0;
            return;
        }
        int nearer = WallTree.NONE;
        int i = 0;
        while (i < size) {
            Vector2 place = place(i);
            nearer = nearer(walls, nearer, place, distance);
            if (nearer == WallTree.NONE) {
                i++;
                continue;
            }
            double nearness = WallReference.nearness(walls.wall(nearer), place, distance);
            // From one place to the next the distance changes by at most a step.
            int alike = (int) Math.min(size, Math.max(0, (nearness - WallReference.ROUNDING) / step));
            int end = Math.min(size, i + 1 + alike);
            Arrays.fill(pieces, i, end, OCCUPIED);
            free -= end - i;
            i = end;
        }
    }

    /** Returns whether one wall is nearer to all places than the distance. */
    private boolean isOccupied(WallTree walls, double distance) {
        int occupier = walls.find(centre, WallReference.nearness(0, distance) - radius, i -> {
            double toCentre = walls.wall(i).distanceTo(centre.x(), centre.y());
            return WallReference.occupiesAround(toCentre, distance, radius);
        });
        return occupier != WallTree.NONE;
    }

    /** Returns a wall that is nearer to a place than the distance, if possible one that is nearer to others. */
    private static int nearer(WallTree walls, int known, Vector2 place, double distance) {
        return known != WallTree.NONE && WallReference.nearness(walls.wall(known), place, distance) > 0
                ? known
                : walls.find(
                        place,
                        WallReference.nearness(0, distance),
                        i -> WallReference.nearness(walls.wall(i), place, distance) > 0);
    }

    /** Returns whether all places are free, in one piece, and apart from those of any other wall. */
    boolean isAlone() {
        return pieces.length < size;
    }

    /** Returns whether any place is free. */
    boolean hasFree() {
        return free > 0;
    }

    boolean isFree(int index) {
        return pieces[isAlone() ? 0 : index] != OCCUPIED;
    }

    /** Returns the piece of a free place. */
    int piece(int index) {
        return pieces[isAlone() ? 0 : index];
    }

    /** Returns the first place, from an index on, that is in a piece; if there is none, the size. */
    int nextInPiece(int start) {
        if (isAlone()) {
            return pieces[0] < 0 ? size : start;
        }
        int i = start;
        while (i < size && pieces[i] < 0) {
            i++;
        }
        return i;
    }

    boolean isPassed(int index) {
        return passed.get(index);
    }

    void setPassed(int index) {
        passed.set(index);
    }

    /** Sets the piece of a place, and of all others if this block is alone. */
    void setPiece(int index, int piece) {
        pieces[isAlone() ? 0 : index] = piece;
    }
}
