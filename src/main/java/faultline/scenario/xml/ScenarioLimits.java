package faultline.scenario.xml;

/**
 * The limits of a scenario file and of its numbers: far above any real file, and low enough to refuse a hostile one at
 * once. Options of the command line and fields of the window have some of them, too.
 */
public final class ScenarioLimits {

    /** The size of a file in bytes. The other limits are reached at about 12 million, if no decisions are recorded. */
    public static final long MAX_BYTES = 16L << 20;

    /** The number of obstacles and of points of polygons, walls and motions, taken together. */
    public static final int MAX_PARTS = 100_000;

    /** The number of elements of a file. */
    static final int MAX_ELEMENTS = 300_000;

    /** The number of sensors of a robot: eight standard ones and 1000 others. */
    public static final int MAX_SENSORS = 1008;

    /** The length of an id, characters. */
    public static final int MAX_ID_LENGTH = 100;

    /** The length of the text before a mistake that a message quotes, characters. */
    public static final int EXCERPT_LENGTH = 40;

    /** The length of the name of a scenario, characters. */
    public static final int MAX_NAME_LENGTH = 10_000;

    /** The length of the description, characters. */
    public static final int MAX_DESCRIPTION_LENGTH = 100_000;

    /** The length of a list of states, characters. */
    public static final int MAX_STATES_LENGTH = 1000;

    /** The nesting depth of elements; the format needs five. */
    static final int MAX_DEPTH = 20;

    /** The fastest wheels, metres per second. */
    public static final double MAX_WHEEL_SPEED = 1000;

    /** The fastest pivot in place, radians per second: otherwise one tick could hold thousands of turns. */
    public static final double MAX_SPIN_RATE = 100_000;

    /** The greatest absolute value of a coordinate, and the greatest size, metres. */
    public static final int MAX_COORDINATE = 100_000;

    /** The longest duration of a run and the latest time of a command, seconds. */
    public static final int MAX_DURATION = 10_000_000;

    /** The shortest tick, seconds. */
    public static final double MIN_TICK = 0.00001;

    /** The longest tick, seconds. */
    public static final double MAX_TICK = 1;

    private ScenarioLimits() {}
}
