package faultline.engine.metrics;

import faultline.geometry.ConvexShape;
import faultline.geometry.Vector2;
import faultline.world.CandidateBuffer;
import java.util.Arrays;
import java.util.BitSet;

/**
 * Up to {@link #LONG} neighbouring places of a row. Those that are free carry the number of the piece of way that they
 * belong to. A run far from all other walls is in one piece, and keeps no numbers for its places.
 */
final class PlaceRun {

    /** The number of a free place that is in no piece yet. */
    static final int NO_PIECE = -1;

    private static final int OCCUPIED = -2;

    /** The greatest number of places of a run near other walls. */
    static final int SHORT = 64;

    /** The greatest number of places of a run alone. */
    static final int LONG = 4096;

    private final PlaceRow row;
    private final int from;
    private final int size;
    private final Vector2 centre;
    private final double radius;
    private final boolean connected;
    private final BitSet passed = new BitSet(0);
    private int[] pieces = {NO_PIECE};

    /** Creates the run of some places of a row. */
    PlaceRun(PlaceRow row, int from, int end, double joinDistance) {
        this.row = row;
        this.from = from;
        size = end - from;
        centre = place(size / 2);
        double most = 0;
        double widest = 0;
        Vector2 before = place(0);
        int step = row instanceof PlaceRow.Side && size > 1 ? size - 1 : 1;
        for (int i = step == 1 ? 0 : step; i < size; i += step) {
            Vector2 place = place(i);
            most = Math.max(most, Math.max(place.distanceTo(centre), before.distanceTo(centre)));
            widest = Math.max(widest, place.distanceTo(before) / step);
            before = place;
        }
        radius = most;
        connected = widest <= joinDistance;
    }

    int size() {
        return size;
    }

    /** Returns the index of the place after this run in its row. */
    int end() {
        return from + size;
    }

    Vector2 centre() {
        return centre;
    }

    /** Returns how far the places are from the centre at most, metres. */
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
     * Finds which places are free; in a run that is too long and not alone, nothing is found.
     *
     * @param wall the wall of the row
     * @param near all walls within the distance of the places, and the join distance besides
     * @param distance of the places from the wall, metres
     * @param shared the number of places at either end of the row that may be near to those of other rows of the wall
     */
    void occupy(ConvexShape wall, CandidateBuffer near, double distance, int shared) {
        boolean alone = connected && from >= shared && end() <= row.size() - shared;
        for (int i = 0; i < near.size(); i++) {
            alone &= near.shape(i) == wall;
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
        int blocker = 0;
        for (int i = 0; i < size; i++) {
            Vector2 place = place(i);
            for (int j = 0; j < near.size() && pieces[i] != OCCUPIED; j++) {
                // The wall that was too near to the last place comes first.
                int candidate = (blocker + j) % near.size();
                if (WallReference.isTooNear(near.shape(candidate), place, distance)) {
                    pieces[i] = OCCUPIED;
                    blocker = candidate;
                }
            }
        }
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

    boolean isPassed(int index) {
        return passed.get(index);
    }

    void setPassed(int index) {
        passed.set(index);
    }

    /** Sets the piece of a place, and of all others if this run is alone. */
    void setPiece(int index, int piece) {
        pieces[isAlone() ? 0 : index] = piece;
    }
}
