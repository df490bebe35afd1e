package faultline.scenario.xml;

/** The limits of numbers in scenario files that options of the command line and fields of the window have too. */
public final class FormatLimits {

    /** The greatest absolute value of a coordinate, and the greatest size, metres. */
    public static final int MAX_COORDINATE = 100_000;

    /** The longest duration of a run and the latest time of a command, seconds. */
    public static final int MAX_DURATION = 10_000_000;

    /** The shortest tick, seconds. */
    public static final double MIN_TICK = 0.00001;

    /** The longest tick, seconds. */
    public static final double MAX_TICK = 1;

    private FormatLimits() {}
}
