package faultline.engine;

import java.util.Arrays;

/**
 * The next thinning of a path, and those after it. A path from before a thinning leads to the later ones, but not the
 * other way round, so that points that were dropped can be collected.
 */
final class PathThinning {

    /** The indexes of the points that were kept, in ascending order; null until it happens. */
    private volatile int[] kept;

    private volatile PathThinning following;

    /** Notes which points were kept, and returns the thinning after this one. */
    PathThinning happened(int[] keptIndexes) {
        following = new PathThinning();
        kept = keptIndexes;
        return following;
    }

    /**
     * Returns how many of the first points of a path remain.
     *
     * @param size the number of points before this thinning, at least 1
     * @param next the thinning that has not yet happened to the points that are counted
     */
    int sizeAfter(int size, PathThinning next) {
        int remaining = size;
        for (PathThinning thinning = this; thinning != next; thinning = thinning.following) {
            int index = Arrays.binarySearch(thinning.kept, remaining);
            remaining = index >= 0 ? index : -index - 1;
        }
        return remaining;
    }
}
