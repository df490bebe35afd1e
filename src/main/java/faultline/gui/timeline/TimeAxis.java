package faultline.gui.timeline;

import faultline.paint.chart.Axis;
import faultline.paint.surface.NiceSteps;

/**
 * The horizontal axis of the time line: the x coordinates of its ends, pixels, the times there, and the time at the end
 * of the run, seconds. It shows the whole run or a part of it; what would reach beyond the run is moved into it.
 */
record TimeAxis(double left, double right, double start, double end, double runEnd) {

    private static final double MIN_STEP_PIXELS = 2;
    private static final double MIN_RUN = 1e-3;
    /** An axis that shows all but this share of the run shows the whole run; the difference is a rounding error. */
    private static final double ROUNDING = 1e-9;
    /** The share of the axis before a time that is brought into view, so that what follows it is visible, too. */
    private static final double LEAD = 0.1;

    TimeAxis {
        right = Math.max(left + 1, right);
        runEnd = Math.max(MIN_RUN, runEnd);
        double length = Math.max(0, end - start);
        boolean whole = !(length < runEnd * (1 - ROUNDING)) || length == 0;
        start = whole ? 0 : Math.max(0, Math.min(start, runEnd - length));
        end = whole ? runEnd : Math.min(runEnd, start + length);
    }

    /** Creates an axis of a whole run. */
    TimeAxis(double left, double right, double runEnd) {
        this(left, right, 0, Math.max(MIN_RUN, runEnd), runEnd);
    }

    /** Returns whether the whole run is visible. */
    boolean isWhole() {
        return start == 0 && end == runEnd;
    }

    /** Returns the time from one end to the other, seconds. */
    double length() {
        return end - start;
    }

    /**
     * Returns the x coordinate of a time, which lies outside the axis if the time is not visible; times after the end
     * of the run are at its end.
     */
    double x(double time) {
        return left + (Math.min(time, runEnd) - start) / length() * (right - left);
    }

    /** Returns the time at an x coordinate, within the axis. */
    double timeAt(double x) {
        return start + shareAt(x) * length();
    }

    private double shareAt(double x) {
        return Math.max(0, Math.min(1, (x - left) / (right - left)));
    }

    /** Returns whether a time is visible; times after the end of the run are at its end. */
    boolean shows(double time) {
        double at = Math.min(time, runEnd);
        return at >= start && at <= end;
    }

    /** Returns a nice step of at least two pixels and at least the length of a tick, seconds. */
    double step(double tick) {
        return NiceSteps.atLeast(Math.max(tick, MIN_STEP_PIXELS * length() / (right - left)));
    }

    /** Returns the labelled axis. */
    Axis ticks() {
        return Axis.linear("s", start, end);
    }

    /**
     * Returns the axis of the same part of a run at the place of another axis; all of the run if this one shows all.
     */
    TimeAxis alignedWith(TimeAxis other) {
        return isWhole()
                ? new TimeAxis(other.left, other.right, other.runEnd)
                : new TimeAxis(other.left, other.right, start, end, other.runEnd);
    }

    /**
     * Returns an axis of a part whose length is multiplied by a factor and at least a minimum, seconds. The time at an
     * x coordinate stays there unless it is too near to an end of the run.
     */
    TimeAxis zoomed(double factor, double x, double minLength) {
        double length = Math.max(Math.min(minLength, length()), length() * factor);
        return startingAt(timeAt(x) - shareAt(x) * length, length);
    }

    /** Returns an axis of a part of the same length that starts at a time, seconds. */
    TimeAxis startingAt(double time) {
        return startingAt(time, length());
    }

    private TimeAxis startingAt(double time, double length) {
        return new TimeAxis(left, right, time, time + length, runEnd);
    }

    /** Returns this axis moved by a number of pixels, positive to later times. */
    TimeAxis moved(double pixels) {
        return startingAt(start + pixels * length() / (right - left));
    }

    /** Returns this axis if it shows a time, or else one that shows it and what follows. */
    TimeAxis showing(double time) {
        return shows(time) ? this : startingAt(Math.min(time, runEnd) - LEAD * length());
    }
}
