package faultline.gui.instrument;

/**
 * A piece of a run that a chart shows.
 *
 * @param start its beginning, seconds; before 0 where the run has not filled the chart yet
 * @param length seconds, in [{@link #MIN_LENGTH}, {@link #MAX_LENGTH}]
 */
record TimeSpan(double start, double length) {

    static final double MIN_LENGTH = 0.2;
    static final double MAX_LENGTH = 100_000;

    /** What a chart shows at first. */
    static final TimeSpan DEFAULT = new TimeSpan(0, 10);

    TimeSpan {
        length = Math.max(MIN_LENGTH, Math.min(MAX_LENGTH, length));
    }

    double end() {
        return start + length;
    }

    /** The time at a share of the span. */
    double timeAt(double share) {
        return start + share * length;
    }

    double shareOf(double time) {
        return (time - start) / length;
    }

    /** So many times as long, with the moment at a share of the span where it is. */
    TimeSpan zoomed(double factor, double share) {
        TimeSpan resized = new TimeSpan(start, length * factor);
        return new TimeSpan(timeAt(share) - share * resized.length, resized.length);
    }

    /** Moved by a share of its length. */
    TimeSpan moved(double share) {
        return new TimeSpan(start + share * length, length);
    }

    /** Moved so that it ends at a time, or begins at 0 where that fills it not. */
    TimeSpan endingAt(double time) {
        return new TimeSpan(Math.max(0, time - length), length);
    }
}
