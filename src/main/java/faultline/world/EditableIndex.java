package faultline.world;

/**
 * An index that is edited: an index of most shapes, and a short list of those added since. Both may hold shapes whose
 * owners have been removed. When edits are many, the index is rebuilt, so that an edit costs a constant on average.
 */
final class EditableIndex {

    private static final int MIN_EDITS = 64;

    private final CandidateBuffer all;
    private SpatialIndex base;
    private int baseSize;
    private int edits;

    /** Creates an index over the shapes of a buffer, which it keeps. */
    EditableIndex(CandidateBuffer all) {
        this.all = all;
        base = SpatialIndex.of(all);
        baseSize = all.size();
    }

    void add(PlacedObstacle obstacle) {
        all.addAll(obstacle);
        edited(obstacle.parts().size());
    }

    void remove(PlacedObstacle obstacle) {
        obstacle.markRemoved();
        edited(obstacle.parts().size());
    }

    private void edited(int shapes) {
        edits += shapes;
        if (edits > MIN_EDITS + baseSize / 4) {
            all.dropRemoved(0);
            base = SpatialIndex.of(all);
            baseSize = all.size();
            edits = 0;
        }
    }

    /** Returns the index of most shapes; it does not change with edits, but may be replaced. */
    SpatialIndex base() {
        return base;
    }

    /** Adds the shapes near a point, and perhaps others. */
    void findNear(double x, double y, double distance, CandidateBuffer found) {
        int before = found.size();
        base.findNear(x, y, distance, found);
        for (int i = baseSize; i < all.size(); i++) {
            if (all.shape(i).distanceTo(x, y) <= distance) {
                found.add(all.shape(i), all.owner(i), i);
            }
        }
        if (edits > 0) {
            found.dropRemoved(before);
        }
    }
}
