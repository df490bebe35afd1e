package faultline.scenario.xml;

/** How big a scenario file may be: far above any real one, and low enough that a hostile one is turned away at once. */
final class ScenarioLimits {

    /** The bytes of a file: the other limits are reached with some 12 million. */
    static final long MAX_BYTES = 16L << 20;

    /** Obstacles and points of polygons, walls and motions, all together. */
    static final int MAX_PARTS = 100_000;

    /** The elements of a file. */
    static final int MAX_ELEMENTS = 300_000;

    /** How deep elements may stand in each other; the format itself needs five. */
    static final int MAX_DEPTH = 20;

    /**
     * A moving obstacle takes at least this to go round its way-points, seconds: otherwise one tick could hold millions
     * of legs.
     */
    static final double MIN_LOOP_TIME = 0.01;

    /** The fastest wheels, metres per second. */
    static final double MAX_WHEEL_SPEED = 1000;

    /** The fastest pivot in place, radians per second: otherwise one tick could hold thousands of turns. */
    static final double MAX_SPIN_RATE = 100_000;

    private ScenarioLimits() {}
}
