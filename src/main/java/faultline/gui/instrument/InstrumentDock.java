package faultline.gui.instrument;

import faultline.engine.Frame;
import faultline.engine.record.RunEvent;
import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.Optional;
import java.util.function.LongConsumer;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;

/**
 * All instruments, on tabs. Only those on the chosen tab are kept up to date, and those some twenty times a second, which eyes take for
 * steady.
 */
public final class InstrumentDock extends JTabbedPane {

    private static final int EVERY = 3;
    private static final Dimension LEAST = new Dimension(400, 120);
    private static final Dimension USUAL = new Dimension(900, 230);

    private final StripChart chart = new StripChart();
    private final StateDiagramView diagram = new StateDiagramView();
    private final TimingInstrument timing = new TimingInstrument();
    private final EventLogView events;
    private final PlacedSplit split;
    private transient Optional<Frame> newest = Optional.empty();
    private int skipped;

    /**
     * Instruments that show nothing yet.
     *
     * @param jump given the tick of an event that the user wants to go to
     */
    public InstrumentDock(LongConsumer jump) {
        events = new EventLogView(jump);
        split = new PlacedSplit(JSplitPane.HORIZONTAL_SPLIT, chart, diagram, 0.5);
        split.place(width -> width / 2);
        add("charts", split);
        add("timing", timing);
        add("events", events);
        setMinimumSize(LEAST);
        setPreferredSize(new Dimension(TextSize.scaled(USUAL.width), TextSize.scaled(USUAL.height)));
        getAccessibleContext().setAccessibleName(Texts.text("instruments"));
        addChangeListener(event -> newest.ifPresent(this::update));
    }

    private void add(String key, JComponent instrument) {
        addTab(Texts.text("instruments." + key), null, instrument, Texts.text("instruments." + key + ".tip"));
    }

    /**
     * Shows a frame, now or with one of the next.
     *
     * @param frame the newest; the same one again is shown for sure before long
     */
    public void show(Frame frame) {
        assert EventQueue.isDispatchThread();
        skipped++;
        boolean isNew = newest.isEmpty() || newest.get() != frame;
        if (skipped >= EVERY && isNew) {
            skipped = 0;
            newest = Optional.of(frame);
            update(frame);
        }
    }

    /**
     * Shows in the event log, from now on, where the run became another than an earlier one.
     *
     * @param divergence empty where it did not
     */
    public void mark(Optional<RunEvent.Diverged> divergence) {
        events.mark(divergence);
    }

    private void update(Frame frame) {
        if (getSelectedComponent() == split) {
            chart.show(frame);
            diagram.show(frame);
        } else if (getSelectedComponent() == timing) {
            timing.show(frame);
        } else {
            events.show(frame);
        }
    }

    /**
     * The divider between strip chart and state diagram.
     *
     * @return the split pane
     */
    public PlacedSplit split() {
        return split;
    }
}
