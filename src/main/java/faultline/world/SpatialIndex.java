package faultline.world;

/** Finds the shapes near a point. */
public interface SpatialIndex {

    /** Up to this number of shapes, looking at all of them is fastest. */
    int MAX_BRUTE_FORCE = 64;

    /**
     * Adds every shape that comes within a distance of a point, and perhaps others, always in the same order.
     *
     * @param x metres
     * @param y metres
     * @param distance metres
     * @param found receives the shapes
     */
    void findNear(double x, double y, double distance, CandidateBuffer found);

    /**
     * {@return an index suited to the number of shapes; the buffer may be cleared afterwards}
     *
     * @param all the shapes to search
     */
    static SpatialIndex of(CandidateBuffer all) {
        return all.size() <= MAX_BRUTE_FORCE ? new BruteForceIndex(all) : new GridIndex(all);
    }
}
