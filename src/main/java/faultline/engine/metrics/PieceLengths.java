package faultline.engine.metrics;

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

    /** Adds the piece of wall of a place; walls come in order, places within a wall in any order. */
    void add(int piece, double length, boolean isPassed, int wall, long rank) {
        all[piece] += length;
        passed[piece] += isPassed ? length : 0;
        if (wall < firstWall[piece] || wall == firstWall[piece] && rank < firstRank[piece]) {
            firstWall[piece] = wall;
            firstRank[piece] = rank;
        }
    }

    /**
     * Returns the share of the piece of which most was passed, of equals the one that begins first; NaN if none was.
     */
    double greatestShare() {
        int best = 0;
        for (int i = 1; i < all.length; i++) {
            boolean earlier =
                    firstWall[i] < firstWall[best] || firstWall[i] == firstWall[best] && firstRank[i] < firstRank[best];
            best = passed[i] > passed[best] || passed[i] == passed[best] && earlier ? i : best;
        }
        return all.length == 0 || passed[best] == 0 ? Double.NaN : passed[best] / all[best];
    }
}
