package faultline.gui;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.InvocationEvent;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;

/**
 * Measures how long the event dispatch thread is busy with each event, by its own processor time, which other programs
 * on the machine do not lengthen, and by the clock. An event that opens a modal dialog is not done before the dialog is
 * closed; what it costs is counted up to the first event that the dialog handles, and after the last.
 */
public final class EventThreadMeter implements AutoCloseable {

    /**
     * One stretch in which the thread did nothing else.
     *
     * @param event the event that it was busy with
     * @param isPaint whether components were painted that had asked for it
     * @param cpu processor time, milliseconds
     * @param wall time by the clock, milliseconds; 0 where a dialog was open, because waiting for the user counts in it
     */
    public record BusyPeriod(String event, boolean isPaint, double cpu, double wall) {}

    private static final double NANOS_PER_MILLI = 1e6;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final List<BusyPeriod> busyPeriods = new ArrayList<>();
    private final MeasuringQueue queue = new MeasuringQueue();
    private long cpu;
    private int depth;
    /** Whether other events were dispatched while the current one is handled. */
    private boolean pumped;

    private EventThreadMeter() {
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(queue);
    }

    /** Starts to measure. */
    public static EventThreadMeter start() {
        return GuiRobot.callOnEdt(EventThreadMeter::new);
    }

    /** Returns all measurements since the last call. */
    public List<BusyPeriod> drain() {
        return GuiRobot.callOnEdt(() -> {
            List<BusyPeriod> taken = List.copyOf(busyPeriods);
            busyPeriods.clear();
            return taken;
        });
    }

    /** Stops measuring. */
    @Override
    public void close() {
        GuiRobot.runOnEdt(queue::remove);
    }

    private final class MeasuringQueue extends EventQueue {

        @Override
        protected void dispatchEvent(AWTEvent event) {
            add("around a dialog", false, 0);
            depth++;
            pumped = false;
            long begun = System.nanoTime();
            super.dispatchEvent(event);
            add(event.toString(), isPaint(event), pumped ? 0 : (System.nanoTime() - begun) / NANOS_PER_MILLI);
            depth--;
            pumped = depth > 0;
        }

        private void add(String event, boolean isPaint, double wall) {
            long now = THREADS.getCurrentThreadCpuTime();
            if (depth > 0) {
                busyPeriods.add(new BusyPeriod(event, isPaint, (now - cpu) / NANOS_PER_MILLI, wall));
            }
            cpu = now;
        }

        private static boolean isPaint(AWTEvent event) {
            return event instanceof InvocationEvent && event.toString().contains("RepaintManager$ProcessingRunnable");
        }

        private void remove() {
            pop();
        }
    }
}
