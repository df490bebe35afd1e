package faultline.scenario;

/** How big a scenario file may be: far above any real one, and low enough that a hostile one is turned away at once. */
final class Limits {

    /** The bytes of a file: the other limits are reached with some 12 million. */
    static final long MOST_BYTES = 16L << 20;

    /** Obstacles and points of polygons, walls and motions, all together. */
    static final int MOST_PARTS = 100_000;

    /** The elements of a file. */
    static final int MOST_ELEMENTS = 300_000;

    /** How deep elements may stand in each other; the format itself needs five. */
    static final int DEEPEST = 20;

    /** A moving obstacle takes at least this to go round its way-points, seconds: otherwise one tick could hold millions of legs. */
    static final double QUICKEST_LOOP = 0.01;

    /** The fastest wheels, metres per second. */
    static final double FASTEST_WHEEL = 1000;

    /** The fastest pivot in place, radians per second: otherwise one tick could hold thousands of turns. */
    static final double FASTEST_SPIN = 100_000;

    private Limits() {
    }
}
