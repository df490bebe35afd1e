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
 * Measures how long the event dispatch thread is busy with each event, by its own processor time, which other programs on the machine do
 * not lengthen, and by the clock. An event that opens a modal dialog is not done before the dialog is closed; what it costs is counted up
 * to the first event that the dialog handles, and after the last.
 */
public final class EventMeter implements AutoCloseable {

    /**
     * One stretch in which the thread did nothing else.
     *
     * @param event the event that it was busy with
     * @param isPaint whether components were painted that had asked for it
     * @param cpu processor time, milliseconds
     * @param wall time by the clock, milliseconds; 0 where a dialog was open, because waiting for the user counts in it
     */
    public record Stretch(String event, boolean isPaint, double cpu, double wall) {
    }

    private static final double NANOS = 1e6;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final List<Stretch> stretches = new ArrayList<>();
    private final Queue queue = new Queue();
    private long cpu;
    private int depth;
    /** Whether the event that is being handled has let others be handled meanwhile. */
    private boolean pumped;

    private EventMeter() {
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(queue);
    }

    /** Measures from now on. */
    public static EventMeter start() {
        return GuiRobot.onEdt(EventMeter::new);
    }

    /** All that was measured so far, and begins anew. */
    public List<Stretch> take() {
        return GuiRobot.onEdt(() -> {
            List<Stretch> taken = List.copyOf(stretches);
            stretches.clear();
            return taken;
        });
    }

    /** Measures no more. */
    @Override
    public void close() {
        GuiRobot.edt(queue::remove);
    }

    private final class Queue extends EventQueue {

        @Override
        protected void dispatchEvent(AWTEvent event) {
            add("around a dialog", false, 0);
            depth++;
            pumped = false;
            long begun = System.nanoTime();
            super.dispatchEvent(event);
            add(event.toString(), isPaint(event), pumped ? 0 : (System.nanoTime() - begun) / NANOS);
            depth--;
            pumped = depth > 0;
        }

        private void add(String event, boolean isPaint, double wall) {
            long now = THREADS.getCurrentThreadCpuTime();
            if (depth > 0) {
                stretches.add(new Stretch(event, isPaint, (now - cpu) / NANOS, wall));
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
