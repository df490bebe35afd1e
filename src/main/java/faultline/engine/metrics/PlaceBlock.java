package faultline.engine.metrics;

import faultline.geometry.ConvexShape;
import faultline.geometry.Vector2;
import faultline.world.CandidateBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Up to {@link #LONG} neighbouring places of a row. Those that are free carry the number of the piece of path that they
 * belong to. A block far from all other walls is in one piece, and keeps no numbers for its places.
 */
final class PlaceBlock {

    /** The number of a free place that is in no piece yet. */
    static final int NO_PIECE = -1;

    private static final int OCCUPIED = -2;

    /** The maximum number of places of a block near other walls. */
    static final int SHORT = 64;

    /** The walls that may be too near are found for this number of places at once. */
    private static final int AHEAD = 8;

    /** The maximum number of places of a block alone. */
    static final int LONG = 4096;

    /** A bound of the error of a distance, metres. */
    private static final double ROUNDING = 1e-9;

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
     * @param near all walls within the distance of the places, and the join distance besides
     * @param distance the distance of the places from the wall, metres
     * @param shared the number of places at either end of the row that may be near to those of other rows of the wall
     */
    void occupy(ConvexShape wall, CandidateBuffer near, double distance, int shared) {
        boolean alone = connected && from >= shared && end() <= row.size() - shared;
        for (int i = 0; alone && i < near.size(); i++) {
            alone = near.shape(i) == wall;
        }
        if (alone) {
            return;
        }
        if (size > SHORT) {
            pieces = new int[size];
            return;
        }
        pieces = new int[size];
        Arrays.fill(pieces, NO_PIECE);
        List<ConvexShape> close = new ArrayList<>();
        for (int i = 0; i < near.size(); i++) {
            if (near.shape(i).distanceTo(centre.x(), centre.y()) <= radius + distance) {
                close.add(near.shape(i));
            }
        }
        occupy(close, distance);
    }

    /** Marks the places that are nearer to a wall than the distance. */
    private void occupy(List<ConvexShape> close, double distance) {
        List<ConvexShape> ahead = List.of();
        int known = 0;
        // The wall that was too near to the last place is tried first.
        ConvexShape blocker = null;
        for (int i = 0; i < size; i++) {
            Vector2 place = place(i);
            if (blocker == null || WallReference.nearness(blocker, place, distance) <= 0) {
                if (i >= known) {
                    ahead = within(close, place, distance + AHEAD * step);
                    known = i + AHEAD;
                }
                blocker = findBlocker(ahead, place, distance);
            }
            if (blocker != null) {
                i = occupy(i, WallReference.nearness(blocker, place, distance));
            }
        }
    }

    private static List<ConvexShape> within(List<ConvexShape> walls, Vector2 place, double radius) {
        List<ConvexShape> within = new ArrayList<>();
        for (ConvexShape wall : walls) {
            if (wall.distanceTo(place.x(), place.y()) <= radius) {
                within.add(wall);
            }
        }
        return within;
    }

    /** Returns a wall that is too near to a place, null if there is none. */
    private static ConvexShape findBlocker(List<ConvexShape> walls, Vector2 place, double distance) {
        for (ConvexShape wall : walls) {
            if (WallReference.nearness(wall, place, distance) > 0) {
                return wall;
            }
        }
        return null;
    }

    /**
     * Marks a place as occupied, and those after it that must be, too, because they are nearer to it than the margin.
     *
     * @return the last place marked
     */
    private int occupy(int index, double margin) {
        int last = (int) Math.min(size - 1, index + Math.max(0, (margin - ROUNDING) / step));
        Arrays.fill(pieces, index, last + 1, OCCUPIED);
        return last;
    }

    /** Returns whether all places are free, in one piece, and apart from those of any other wall. */
    boolean isAlone() {
        return pieces.length < size;
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
