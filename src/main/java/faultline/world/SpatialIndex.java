package faultline.world;

import faultline.geometry.ConvexShape;

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

    /** {@return the number of shapes} */
    int size();

    /**
     * {@return a shape}
     *
     * @param number the number of the shape, from 0, in the order in which they were added
     */
    ConvexShape shape(int number);

    /** {@return an index of the same shapes that is independent of this one, so that another thread may use it} */
    SpatialIndex copy();

    /**
     * {@return an index of the static shapes of a world, the enclosing wall first}
     *
     * @param world the world
     */
    static SpatialIndex ofStaticShapes(WorldSpec world) {
        return of(ObstacleSet.staticShapes(world));
    }

    /**
     * {@return an index suited to the number of shapes; the buffer may be cleared afterwards}
     *
     * @param all the shapes to search
     */
    static SpatialIndex of(CandidateBuffer all) {
        return all.size() <= MAX_BRUTE_FORCE ? new BruteForceIndex(all) : new GridIndex(all);
    }
}
