package faultline.world;

/** Finds the static figures near a point. */
public interface SpatialIndex {

    /**
     * Adds every figure that comes within a distance of a point, and perhaps some that do not, always in the same
     * order.
     *
     * @param x metres
     * @param y metres
     * @param distance metres
     * @param found where they are added
     */
    void findNear(double x, double y, double distance, CandidateBuffer found);

    /** The index that suits a number of figures: below some dozens, looking at all of them is fastest. */
    static SpatialIndex of(CandidateBuffer all) {
        return all.size() <= 64 ? new BruteForceIndex(all) : new GridIndex(all);
    }
}
