package faultline.gui.instrument;

import faultline.control.ControllerSpec;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.timeline.TimelineItem;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.function.LongConsumer;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;

/** All instruments, on tabs. Only those on the selected tab are updated, about twenty times per second. */
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
    private transient List<TimelineItem> shownItems = List.of();
    private int skippedFrames;

    /**
     * Creates empty instruments.
     *
     * @param jump receives the tick of an event to go to
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
     * Shows a frame, immediately or with one of the next updates.
     *
     * @param frame the newest frame; repeated calls with the same frame show it eventually
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

    /** Shows in the event log where the run differs from the reference run, or removes the mark. */
    public void setDivergence(Optional<RunEvent.Diverged> divergence) {
        events.setDivergence(divergence);
    }

    /** Sets the items of the time line that the charts mark; the same list as before changes nothing. */
    public void setItems(List<TimelineItem> items) {
        if (items != shownItems) {
            shownItems = items;
            chart.setItems(items);
        }
    }

    /** Shows the values of a reference run in the chart, null for none. */
    public void setReference(ReferenceRun run) {
        chart.setReference(run);
    }

    /** Returns the strip chart. */
    public StripChart chart() {
        return chart;
    }

    /** Prepares for another scenario: names its timing rule and releases a held chart. */
    public void startScenario(ControllerSpec controller) {
        chart.release();
        showTimingRule(controller);
    }

    private void showTimingRule(ControllerSpec controller) {
        if (controller instanceof ControllerSpec.WallFollowing following) {
            alignment.setTimingRule(following.timingRule());
        }
    }

    private void update(SessionFrame frame) {
        if (getSelectedComponent() == split) {
            chart.setFrame(frame);
            diagram.setFrame(frame);
        } else if (getSelectedComponent() == alignment) {
            showTimingRule(frame.controller());
            alignment.setFrame(frame);
        } else {
            events.setFrame(frame);
        }
    }

    /** Returns the split pane between strip chart and state diagram. */
    public PositionedSplitPane split() {
        return split;
    }
}
