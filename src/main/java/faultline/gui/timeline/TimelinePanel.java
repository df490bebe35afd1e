package faultline.gui.timeline;

import faultline.engine.Frame;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.SeparatorBorder;
import faultline.gui.theme.TextSize;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JViewport;
import javax.swing.ScrollPaneConstants;

/** The time line: the slider of the run, and below it the lanes, whose times are aligned with the slider. */
public final class TimelinePanel extends JPanel {

    /** The share of the window's height that the lanes take where there is little room. */
    private static final double MIN_WINDOW_SHARE = 0.1;

    /** The height below which no lane would be fully visible, pixels at the normal text size. */
    private static final int LOWEST_LANES = 28;

    private static final int LANE_NAME_WIDTH = 80;

    private final TimeBar bar;
    private final LaneView lanes;
    private final JScrollPane scroll;
    private final transient TimelineEditor editor;
    /** The data from which the marks on the slider were made. */
    private transient List<Object> markedState = List.of();

    /**
     * Creates a time line without a run. {@code jump} receives the tick to go to, and {@code preview} keyframes while
     * the thumb is dragged.
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
        // The ruler stays while the lanes scroll below it.
        scroll.getViewport().setScrollMode(JViewport.SIMPLE_SCROLL_MODE);
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

    public LaneView lanes() {
        return lanes;
    }

    /** Shows or hides the lanes. */
    public void setLanesShown(boolean shown) {
        scroll.setVisible(shown);
        revalidate();
    }

    /**
     * Shows the current tick, the last one and that of the scenario's duration; {@code dt} is the length of a tick,
     * seconds.
     */
    public void setFrame(SessionFrame frame, long end, long scenarioEnd, double dt) {
        bar.setFrame(frame, end, dt);
        updateMarks(frame, scenarioEnd, dt);
        if (scroll.isVisible()) {
            lanes.update(
                    lanesOf(frame.snapshot().sensors().stream().map(SensorSnapshot::spec)),
                    bar.axis(),
                    bar.shownTime());
        }
    }

    /** Aligns the lanes with the slider also before the first frame, and while there is no newer frame. */
    @Override
    protected void validateTree() {
        super.validateTree();
        if (lanes.isEnabled()) {
            lanes.setAxis(bar.axis());
        } else {
            lanes.setEmptyLanes(lanesOf(RobotSpec.DEFAULT.sensors().stream()), bar.axis());
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

    private static List<Lane> lanesOf(Stream<SensorSpec> sensors) {
        List<Lane> result = new ArrayList<>();
        sensors.forEach(sensor -> result.add(new Lane.SensorLane(sensor.id())));
        for (MotorSide side : MotorSide.values()) {
            result.add(new Lane.MotorLane(side));
        }
        result.add(Lane.OTHER);
        return result;
    }

    /** Prepares for another scenario. */
    public void startScenario() {
        lanes.startScenario();
    }

    /** Returns the height of the time line in a window where there is little room, pixels. */
    public int minHeight(int windowHeight) {
        return sliderHeight() + (scroll.isVisible() ? (int) (MIN_WINDOW_SHARE * windowHeight) : 0);
    }

    /** Limits the height of the lanes: the canvas above them keeps at least half of the window. */
    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        int excess = getParent() == null ? 0 : lanesExcess(maxLanesHeight());
        return new Dimension(size.width, size.height - excess);
    }

    /** Returns by how much the preferred height of the lanes exceeds a height, pixels. */
    private int lanesExcess(int height) {
        return scroll.isVisible() ? Math.max(0, lanes.getPreferredScrollableViewportSize().height - height) : 0;
    }

    private int maxLanesHeight() {
        int stage = getParent().getHeight();
        int window = getRootPane() == null ? stage : getRootPane().getHeight();
        int least = (int) (MIN_WINDOW_SHARE * window);
        int room = stage - sliderHeight() - (window + 1) / 2;
        if (room >= least || stage == 0) {
            return Math.max(room, least);
        }
        // Beside large instruments the canvas has less than half of the window anyway; then the lanes grow with their
        // text, as long as the canvas has half of what is left.
        int shared = Math.min(TextSize.scaled(least), stage / 2 - sliderHeight());
        return shared >= TextSize.scaled(LOWEST_LANES) ? shared : 0;
    }

    private int sliderHeight() {
        Insets insets = getInsets();
        return bar.getPreferredSize().height + insets.top + insets.bottom + 1;
    }
}
