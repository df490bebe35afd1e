package faultline.gui.timeline;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleSupplier;

/** The part of the run that the lanes show. Event dispatch thread only. */
final class LaneZoom {

    /** The factor of one step of a key or of the wheel. */
    private static final double STEP = 1.25;

    private static final int MIN_TICKS = 20;

    private final DoubleSupplier tickLength;
    private final List<Runnable> listeners = new ArrayList<>();
    private TimeAxis axis = new TimeAxis(0, 1, 1);

    /** Creates a zoom that shows the whole run, given the length of a tick, seconds. */
    LaneZoom(DoubleSupplier tickLength) {
        this.tickLength = tickLength;
    }

    /** Adds a listener for changes of the axis. */
    void addListener(Runnable listener) {
        listeners.add(listener);
    }

    TimeAxis axis() {
        return axis;
    }

    /** Returns whether the axis can show less. */
    boolean canZoomIn() {
        return axis.length() > minLength() * (1 + 1e-9);
    }

    private double minLength() {
        return MIN_TICKS * tickLength.getAsDouble();
    }

    private void show(TimeAxis newAxis) {
        if (!newAxis.equals(axis)) {
            axis = newAxis;
            listeners.forEach(Runnable::run);
        }
    }

    /** Aligns the axis with one of the whole run. */
    void alignWith(TimeAxis whole) {
        show(axis.alignedWith(whole));
    }

    /** Zooms by a number of steps, positive to show less; the time at an x coordinate stays there. */
    void zoom(double steps, double x) {
        show(axis.zoomed(Math.pow(STEP, -steps), x, minLength()));
    }

    /** Zooms by a number of steps about a time, or about the middle if the time is not visible. */
    void zoomAbout(double steps, double time) {
        zoom(steps, axis.shows(time) ? axis.x(time) : (axis.left() + axis.right()) / 2);
    }

    /** Shows the whole run. */
    void showAll() {
        show(new TimeAxis(axis.left(), axis.right(), axis.runEnd()));
    }

    /** Moves by a number of pixels, positive to later times. */
    void move(double pixels) {
        show(axis.moved(pixels));
    }

    /** Moves to a part that starts at a time, seconds. */
    void moveTo(double start) {
        show(axis.startingAt(start));
    }

    /** Moves to a part with a time, unless the time is visible. */
    void showTime(double time) {
        show(axis.showing(time));
    }

    /**
     * Follows the present time to a new one if it was visible; otherwise the user has moved away from it and does not
     * want to be moved back.
     */
    void follow(double before, double now) {
        if (axis.shows(before)) {
            showTime(now);
        }
    }

    /** Moves to the start of an item if no part of it is visible. */
    void showItem(TimelineItem item) {
        if (axis.x(item.end()) < axis.left() || axis.x(item.start()) > axis.right()) {
            showTime(item.start());
        }
    }
}
