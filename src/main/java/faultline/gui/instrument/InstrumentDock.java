package faultline.gui.instrument;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import faultline.gui.timeline.TimelineItem;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;

/** All instruments, on tabs. Only those on the selected tab are updated, about twenty times per second. */
public final class InstrumentDock extends JTabbedPane {

    private static final int FRAMES_PER_UPDATE = 3;
    private static final Dimension MIN_SIZE = new Dimension(400, 120);
    private static final Dimension DEFAULT_SIZE = new Dimension(900, 196);

    private final StripChart chart = new StripChart();
    private final StateDiagramView diagram = new StateDiagramView();
    private final AlignmentView alignment = new AlignmentView();
    private final EventLogView events;
    private final PositionedSplitPane split;
    /** Null before the first frame. */
    private transient SessionFrame newestFrame;

    private transient List<TimelineItem> shownItems = List.of();
    private transient Supplier<List<String>> printedLines = List::of;

    private int skippedFrames;

    /** Creates empty instruments; {@code jump} receives the tick of an event to go to. */
    public InstrumentDock(LongConsumer jump) {
        events = new EventLogView(jump);
        split = new PositionedSplitPane("divider.chart", JSplitPane.HORIZONTAL_SPLIT, chart, diagram, 0.5);
        split.place(width -> width / 2);
        addInstrument("charts", split);
        addInstrument("timing", alignment);
        addInstrument("events", events);
        setMinimumSize(MIN_SIZE);
        RefreshSteps.add(
                this,
                dock -> dock.setPreferredSize(
                        new Dimension(TextSize.scaled(DEFAULT_SIZE.width), TextSize.scaled(DEFAULT_SIZE.height))));
        UiText.name(this, "instruments");
        addChangeListener(event -> update());
    }

    private void addInstrument(String key, JComponent instrument) {
        UiText.addTab(this, "instruments." + key, instrument);
    }

    /**
     * Shows the newest frame, immediately or with one of the next updates; repeated calls with it show it eventually.
     */
    public void setFrame(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        skippedFrames++;
        if (skippedFrames < FRAMES_PER_UPDATE) {
            return;
        }
        List<String> lines = printedLines.get();
        if (newestFrame != frame || !lines.isEmpty()) {
            skippedFrames = 0;
            newestFrame = frame;
            if (!lines.isEmpty()) {
                events.addLines(lines, frame);
            }
            update();
        }
    }

    /** Gives the sensors the ids that they have in the next frame, which is shown at once. */
    public void renameSensors(UnaryOperator<String> presentId) {
        chart.renameSensors(presentId);
        skippedFrames = FRAMES_PER_UPDATE;
    }

    /** Shows in the event log where the run differs from the reference run, null for nowhere. */
    public void setDivergence(RunEvent.Diverged divergence) {
        events.setDivergence(divergence);
    }

    /** Sets the source of the lines that programs have printed, for the event log. It is asked with each update. */
    public void setPrintedLines(Supplier<List<String>> source) {
        printedLines = source;
    }

    /** Prepares for another run: removes the events of the run before. */
    public void startRun() {
        events.clear();
    }

    /** Sets the contact of the reference run, which the event log lists, null for none. */
    public void setGhostContact(RunEvent.GhostCollided contact) {
        events.setGhostContact(contact);
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

    public StripChart chart() {
        return chart;
    }

    /** Returns the content of the chart for a frame, also if the chart is not shown; empty if it has none. */
    public Optional<StripContent> chartContent(SessionFrame frame) {
        chart.setFrame(frame);
        return chart.content();
    }

    /** Prepares for another scenario: releases a held chart. */
    public void startScenario() {
        chart.release();
    }

    private void update() {
        if (newestFrame == null) {
            return;
        }
        if (getSelectedComponent() == split) {
            chart.setFrame(newestFrame);
            diagram.setFrame(newestFrame);
        } else if (getSelectedComponent() == alignment) {
            alignment.setFrame(newestFrame);
        } else {
            events.setFrame(newestFrame);
        }
    }

    /** Returns the width of the strip chart, pixels, if the user has moved the divider beside it. */
    public Optional<Integer> chosenChartWidth() {
        return split.isMoved() ? Optional.of(split.getDividerLocation()) : Optional.empty();
    }

    /** Sets the width of the strip chart, pixels. */
    public void setChartWidth(int width) {
        split.place(size -> width);
    }

    /** Returns the split pane between strip chart and state diagram. */
    public PositionedSplitPane split() {
        return split;
    }
}
