package faultline.gui.instrument;

import faultline.engine.session.SessionFrame;
import faultline.engine.recording.RunEvent;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.Optional;
import java.util.function.LongConsumer;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;

/**
 * All instruments, on tabs. Only those on the chosen tab are kept up to date, and those some twenty times a second,
 * which eyes take for steady.
 */
public final class InstrumentDock extends JTabbedPane {

    private static final int FRAMES_PER_UPDATE = 3;
    private static final Dimension MIN_SIZE = new Dimension(400, 120);
    private static final Dimension DEFAULT_SIZE = new Dimension(900, 230);

    private final StripChart chart = new StripChart();
    private final StateDiagramView diagram = new StateDiagramView();
    private final AlignmentView alignment = new AlignmentView();
    private final EventLogView events;
    private final PositionedSplitPane split;
    private transient Optional<SessionFrame> newestFrame = Optional.empty();
    private int skippedFrames;

    /**
     * Instruments that show nothing yet.
     *
     * @param jump given the tick of an event that the user wants to go to
     */
    public InstrumentDock(LongConsumer jump) {
        events = new EventLogView(jump);
        split = new PositionedSplitPane(JSplitPane.HORIZONTAL_SPLIT, chart, diagram, 0.5);
        split.place(width -> width / 2);
        addInstrument("charts", split);
        addInstrument("timing", alignment);
        addInstrument("events", events);
        setMinimumSize(MIN_SIZE);
        setPreferredSize(new Dimension(TextSize.scaled(DEFAULT_SIZE.width), TextSize.scaled(DEFAULT_SIZE.height)));
        getAccessibleContext().setAccessibleName(Messages.get("instruments"));
        addChangeListener(event -> newestFrame.ifPresent(this::update));
    }

    private void addInstrument(String key, JComponent instrument) {
        addTab(Messages.get("instruments." + key), null, instrument, Messages.get("instruments." + key + ".tip"));
    }

    /**
     * Shows a frame, now or with one of the next.
     *
     * @param frame the newest; the same one again is shown for sure before long
     */
    public void setFrame(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        skippedFrames++;
        boolean isNew = newestFrame.isEmpty() || newestFrame.get() != frame;
        if (skippedFrames >= FRAMES_PER_UPDATE && isNew) {
            skippedFrames = 0;
            newestFrame = Optional.of(frame);
            update(frame);
        }
    }

    /**
     * Shows in the event log, from now on, where the run became another than an earlier one.
     *
     * @param divergence empty where it did not
     */
    public void setDivergence(Optional<RunEvent.Diverged> divergence) {
        events.setDivergence(divergence);
    }

    private void update(SessionFrame frame) {
        if (getSelectedComponent() == split) {
            chart.setFrame(frame);
            diagram.setFrame(frame);
        } else if (getSelectedComponent() == alignment) {
            alignment.setFrame(frame);
        } else {
            events.setFrame(frame);
        }
    }

    /**
     * The divider between strip chart and state diagram.
     *
     * @return the split pane
     */
    public PositionedSplitPane split() {
        return split;
    }
}
