package faultline.engine;

import java.util.Arrays;

/**
 * The next thinning of a path, and those after it. A path from before a thinning refers to the later thinnings, but not
 * vice versa, so that dropped points can be garbage-collected.
 */
final class PathThinning {

    /** The indexes of the points that were kept, in ascending order; null before the thinning. */
    private volatile int[] kept;

    private volatile PathThinning following;

    /** Records which points were kept, and returns the thinning after this one. */
    PathThinning happened(int[] keptIndexes) {
        following = new PathThinning();
        kept = keptIndexes;
        return following;
    }

    /**
     * Returns how many of the first points of a path remain.
     *
     * @param size the number of points before this thinning, at least 1
     * @param next the first thinning that has not yet been applied to the counted points
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
