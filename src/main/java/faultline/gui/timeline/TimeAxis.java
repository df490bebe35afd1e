package faultline.gui.timeline;

import faultline.paint.chart.Axis;
import faultline.paint.surface.NiceSteps;

/**
 * The horizontal axis of the time line, from time 0: the x coordinates of its ends, pixels, and the time at its end,
 * seconds.
 */
record TimeAxis(double left, double right, double end) {

    private static final double MIN_STEP_PIXELS = 2;

    TimeAxis {
        right = Math.max(left + 1, right);
        end = Math.max(1e-3, end);
    }

    /** Returns the x coordinate of a time; times after the end are at the end. */
    double x(double time) {
        return left + Math.min(time, end) / end * (right - left);
    }

    /** Returns the time at an x coordinate, within the axis. */
    double timeAt(double x) {
        return Math.max(0, Math.min(1, (x - left) / (right - left))) * end;
    }

    /** Returns a nice step of at least two pixels and at least the length of a tick, seconds. */
    double step(double tick) {
        return NiceSteps.atLeast(Math.max(tick, MIN_STEP_PIXELS * end / (right - left)));
    }

    /** Returns the labelled axis. */
    Axis ticks() {
        return Axis.linear("s", 0, end);
    }
}
