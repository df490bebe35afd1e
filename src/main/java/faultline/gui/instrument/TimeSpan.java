package faultline.gui.instrument;

/**
 * The time span that a chart shows, seconds. The start is negative only after zooming or scrolling; the length is in
 * [{@link #MIN_LENGTH}, {@link #MAX_LENGTH}].
 */
record TimeSpan(double start, double length) {

    static final double MIN_LENGTH = 0.2;
    static final double MAX_LENGTH = 100_000;

    /** The span that a chart shows initially. */
    static final TimeSpan DEFAULT = new TimeSpan(0, 10);

    TimeSpan {
        length = Math.max(MIN_LENGTH, Math.min(MAX_LENGTH, length));
    }

    double end() {
        return start + length;
    }

    double timeAt(double share) {
        return start + share * length;
    }

    /** Returns this span scaled by a factor, with the time at the given share kept in place. */
    TimeSpan zoomed(double factor, double share) {
        TimeSpan resized = new TimeSpan(start, length * factor);
        return new TimeSpan(timeAt(share) - share * resized.length, resized.length);
    }

    /** Returns this span moved by a share of its length. */
    TimeSpan moved(double share) {
        return new TimeSpan(start + share * length, length);
    }

    /** Returns this span moved to end at a time, or to start at 0 if the time is smaller than the length. */
    TimeSpan endingAt(double time) {
        return new TimeSpan(Math.max(0, time - length), length);
    }
}
