package faultline.gui.instrument;

/**
 * A piece of a run that a chart shows.
 *
 * @param from its beginning, seconds; before 0 where the run has not filled the chart yet
 * @param length seconds, in [{@link #SHORTEST}, {@link #LONGEST}]
 */
record TimeSpan(double from, double length) {

    static final double SHORTEST = 0.2;
    static final double LONGEST = 100_000;

    /** What a chart shows at first. */
    static final TimeSpan USUAL = new TimeSpan(0, 10);

    TimeSpan {
        length = Math.max(SHORTEST, Math.min(LONGEST, length));
    }

    double to() {
        return from + length;
    }

    /** The time at a share of the span. */
    double at(double share) {
        return from + share * length;
    }

    double share(double time) {
        return (time - from) / length;
    }

    /** So many times as long, with the moment at a share of the span where it is. */
    TimeSpan scaled(double factor, double share) {
        TimeSpan resized = new TimeSpan(from, length * factor);
        return new TimeSpan(at(share) - share * resized.length, resized.length);
    }

    /** Moved by a share of its length. */
    TimeSpan moved(double share) {
        return new TimeSpan(from + share * length, length);
    }

    /** Moved so that it ends at a time, or begins at 0 where that fills it not. */
    TimeSpan endingAt(double time) {
        return new TimeSpan(Math.max(0, time - length), length);
    }
}
