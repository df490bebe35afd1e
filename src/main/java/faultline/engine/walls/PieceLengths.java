package faultline.engine.walls;

import java.util.Arrays;

/** Sums up how much wall belongs to each connected piece of path, and how much of it was passed. */
final class PieceLengths {

    private final double[] passed;
    private final double[] all;
    private final int[] firstWall;
    private final long[] firstRank;

    PieceLengths(int pieces) {
        passed = new double[pieces];
        all = new double[pieces];
        firstWall = new int[pieces];
        firstRank = new long[pieces];
        Arrays.fill(firstWall, Integer.MAX_VALUE);
    }

    /** Adds the pieces of wall of the places of a block; walls come in order, the blocks of a wall in any order. */
    void add(PlaceBlock block, int wall) {
        for (int i = block.nextInPiece(0); i < block.size(); i = block.nextInPiece(i + 1)) {
            int piece = block.piece(i);
            addLength(piece, block, i);
            if (wall <= firstWall[piece]) {
                addStart(piece, wall, block.rank(i));
            }
        }
    }

    private void addLength(int piece, PlaceBlock block, int index) {
        double length = block.wallLength(index);
        if (length > 0) {
            all[piece] += length;
            passed[piece] += block.isPassed(index) ? length : 0;
        }
    }

    private void addStart(int piece, int wall, long rank) {
        if (wall < firstWall[piece] || rank < firstRank[piece]) {
            firstWall[piece] = wall;
            firstRank[piece] = rank;
        }
    }

    /**
     * Returns the passed share of the piece of which most was passed; of equals, of the one that begins first. NaN if
     * none was passed.
     */
    double shareOfMostPassed() {
        int best = 0;
        for (int i = 1; i < all.length; i++) {
            boolean earlier =
                    firstWall[i] < firstWall[best] || firstWall[i] == firstWall[best] && firstRank[i] < firstRank[best];
            best = passed[i] > passed[best] || passed[i] == passed[best] && earlier ? i : best;
        }
        return all.length == 0 || passed[best] == 0 ? Double.NaN : passed[best] / all[best];
    }
}
