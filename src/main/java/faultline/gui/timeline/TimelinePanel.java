package faultline.gui.timeline;

import faultline.engine.Frame;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.SeparatorBorder;
import faultline.gui.theme.TextSize;
import faultline.robot.MotorSide;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;

/** The time line: the slider of the run, and below it the lanes, whose times are aligned with the slider. */
public final class TimelinePanel extends JPanel {

    /** The largest share of the window's height that the lanes take. */
    private static final double MAX_WINDOW_SHARE = 0.2;
    /** The largest share of the height of canvas and time line that the lanes take. */
    private static final double MAX_STAGE_SHARE = 0.3;

    private static final int LANE_NAME_WIDTH = 80;

    private final TimeBar bar;
    private final LaneView lanes;
    private final JScrollPane scroll;
    private final transient TimelineEditor editor;
    /** What the marks on the slider were made of. */
    private transient List<Object> markedState = List.of();

    /**
     * Creates a time line without a run.
     *
     * @param jump receives the tick to go to
     * @param preview receives keyframes while the thumb is dragged
     * @param editor changes the scenario's timeline
     */
    public TimelinePanel(LongConsumer jump, Consumer<Frame> preview, TimelineEditor editor) {
        super(new BorderLayout(0, 1));
        this.editor = editor;
        bar = new TimeBar(jump, preview);
        RefreshSteps.add(bar, self -> {
            self.setLeadingWidth(TextSize.scaled(LANE_NAME_WIDTH));
            // The next frame makes the marks again, whose tool tips have words.
            markedState = List.of();
        });
        lanes = new LaneView(editor);
        scroll = new JScrollPane(
                lanes,
                ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        setBorder(SeparatorBorder.above(3, 14, 3));
        add(bar, BorderLayout.NORTH);
        add(scroll, BorderLayout.CENTER);
    }

    /** Returns the slider. */
    public TimeBar bar() {
        return bar;
    }

    /** Returns the items of the scenario's timeline; the same list as before if nothing has changed. */
    public List<TimelineItem> items() {
        return editor.model().items();
    }

    /** Returns the lanes. */
    public LaneView lanes() {
        return lanes;
    }

    /** Shows or hides the lanes. */
    public void setLanesShown(boolean shown) {
        scroll.setVisible(shown);
        revalidate();
    }

    /**
     * Shows the current tick and the last one.
     *
     * @param end the last tick
     * @param scenarioEnd the last tick of the scenario's duration
     * @param dt the length of a tick, seconds
     */
    public void setFrame(SessionFrame frame, long end, long scenarioEnd, double dt) {
        bar.setFrame(frame, end, dt);
        updateMarks(frame, scenarioEnd, dt);
        if (scroll.isVisible()) {
            lanes.update(lanesOf(frame), bar.axis(), bar.shownTime());
        }
    }

    /** Makes new marks only if something has happened since the last ones. */
    private void updateMarks(SessionFrame frame, long scenarioEnd, double dt) {
        EventLog log = frame.recording().events();
        RunEvent first = log.endIndex() > log.firstIndex() ? log.get(log.firstIndex()) : null;
        List<Object> state = Arrays.asList(editor.model(), log.endIndex(), first, scenarioEnd);
        if (!state.equals(markedState)) {
            markedState = state;
            bar.setMarks(RunMarks.of(frame, editor.model().items(), scenarioEnd, dt));
        }
    }

    private static List<Lane> lanesOf(SessionFrame frame) {
        List<Lane> result = new ArrayList<>();
        frame.snapshot()
                .sensors()
                .forEach(sensor -> result.add(new Lane.OfSensor(sensor.spec().id())));
        for (MotorSide side : MotorSide.values()) {
            result.add(new Lane.OfMotors(side));
        }
        result.add(Lane.OTHER);
        return result;
    }

    /** Limits the height of the lanes: it must not change when the instruments are hidden and the canvas grows. */
    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        int excess = scroll.isVisible() && getParent() != null
                ? Math.max(0, lanes.getPreferredScrollableViewportSize().height - maxLanesHeight())
                : 0;
        return new Dimension(size.width, size.height - excess);
    }

    private int maxLanesHeight() {
        int window =
                getRootPane() == null ? getParent().getHeight() : getRootPane().getHeight();
        return (int) Math.min(
                MAX_WINDOW_SHARE * window, MAX_STAGE_SHARE * getParent().getHeight());
    }
}
