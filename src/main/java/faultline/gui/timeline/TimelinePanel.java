package faultline.gui.timeline;

import faultline.engine.Frame;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.Point;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.function.UnaryOperator;
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
    /** The height of the scroll bar between the slider and the lanes, which shows while they are zoomed. */
    private static final int TIME_SCROLL_HEIGHT = 9;
    /** By how much it covers the slider, below its thumb, pixels. */
    private static final int TIME_SCROLL_OVERLAP = 4;

    private final TimeBar bar;
    private final LaneView lanes;
    private final JScrollPane scroll;
    private final TimeScrollBar timeScroll;
    private final transient TimelineEditor editor;
    private final transient List<Runnable> lanesListeners = new ArrayList<>();
    /** The data from which the marks on the slider were made. */
    private transient List<Object> markedState = List.of();
    /** The newest event for which the marks were made; null for none. */
    private transient RunEvent markedEvent;

    private transient EventStops stops = EventStops.NONE;
    /** The contact of the reference run; null for none. */
    private transient RunEvent.GhostCollided ghostContact;

    /**
     * Creates a time line without a run. {@code jump} receives the tick to go to, and {@code preview} keyframes while
     * the thumb is dragged.
     */
    public TimelinePanel(LongConsumer jump, Consumer<Frame> preview, TimelineEditor editor) {
        super(null);
        this.editor = editor;
        bar = new TimeBar(jump, preview);
        RefreshSteps.add(bar, self -> {
            self.setLeadingWidth(TextSize.scaled(LANE_NAME_WIDTH));
            // The next frame makes the marks again, whose tool tips have words.
            markedState = List.of();
        });
        lanes = new LaneView(editor);
        lanes.addPropertyChangeListener(LaneView.ROWS_PROPERTY, event -> lanesChanged());
        scroll = createScrollPane();
        timeScroll = new TimeScrollBar(lanes.zoom());
        setBorder(BorderFactory.createEmptyBorder(0, 14, 1, 14));
        add(timeScroll);
        add(bar);
        add(scroll);
    }

    /** Creates the scroll pane of the lanes, which scrolls by whole rows below the ruler. */
    private JScrollPane createScrollPane() {
        JScrollPane pane = new JScrollPane(
                null, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        pane.setViewport(new JViewport() {
            @Override
            public void setViewPosition(Point position) {
                super.setViewPosition(new Point(position.x, lanes.scrollPosition(position.y)));
            }
        });
        pane.setViewportView(lanes);
        // The ruler stays while the lanes scroll below it.
        pane.getViewport().setScrollMode(JViewport.SIMPLE_SCROLL_MODE);
        pane.setBorder(BorderFactory.createEmptyBorder());
        return pane;
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

    LaneZoom zoom() {
        return lanes.zoom();
    }

    /** Adds a listener for changes of the number of rows of the lanes, and of whether they are shown. */
    public void addLanesListener(Runnable listener) {
        lanesListeners.add(listener);
    }

    private void lanesChanged() {
        lanesListeners.forEach(Runnable::run);
    }

    /** Shows or hides the lanes. */
    public void setLanesShown(boolean shown) {
        scroll.setVisible(shown);
        timeScroll.setShown(shown);
        revalidate();
        lanesChanged();
    }

    public boolean areLanesShown() {
        return scroll.isVisible();
    }

    /** Shows the part of the run with a tick, unless it is visible. */
    void showTick(long tick) {
        lanes.zoom().showTime(bar.timeOf(tick));
    }

    String tickText(long tick) {
        return bar.tickText(tick);
    }

    /** Sets the contact of the reference run, which is marked with the next frame; null for none. */
    public void setGhostContact(RunEvent.GhostCollided contact) {
        ghostContact = contact;
    }

    /** Returns the ticks with a mark. */
    EventStops stops() {
        return stops;
    }

    /** Shows the tick of a frame, the last tick and that of the scenario's duration. */
    public void setFrame(SessionFrame frame, long end, long scenarioEnd) {
        bar.setFrame(frame, end);
        updateMarks(frame, scenarioEnd);
        if (bar.isAdjusting()) {
            lanes.zoom().showTime(bar.shownTime());
        }
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

    /** Makes new marks only if something has happened since the last ones, or the events are those of another run. */
    private void updateMarks(SessionFrame frame, long scenarioEnd) {
        EventLog log = frame.recording().events();
        RunEvent newest = log.endIndex() > log.firstIndex() ? log.get(log.endIndex() - 1) : null;
        // The reference run may be longer than the slider.
        List<RunEvent> ofGhost = Stream.<RunEvent>of(bar.divergence(), ghostContact)
                .filter(event -> event != null && event.tick() <= bar.end())
                .toList();
        List<Object> state = Arrays.asList(
                editor.model(),
                log.firstIndex(),
                log.endIndex(),
                frame.snapshot().robot(),
                scenarioEnd,
                frame.dt(),
                ofGhost);
        // Another run may have as many events, the newest one equal, but it has other event objects.
        if (newest != markedEvent || !state.equals(markedState)) {
            markedState = state;
            markedEvent = newest;
            bar.setMarks(RunMarks.of(frame, editor.model().items(), scenarioEnd, ofGhost));
            List<EventStops.Stop> marked =
                    new ArrayList<>(RunMarks.stops(frame, editor.model().items()));
            ofGhost.forEach(event -> marked.add(new EventStops.Stop(event.tick(), () -> EventText.sentence(event))));
            stops = new EventStops(marked);
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

    /** Gives the selected lane the id that its sensor has in the next frame, as returned for the present one. */
    public void renameSensors(UnaryOperator<String> presentId) {
        lanes.renameSensors(presentId);
    }

    /** Prepares for another scenario. */
    public void startScenario() {
        bar.startScenario();
        lanes.startScenario();
    }

    /** Returns the height of the time line in a window where there is little room, pixels. */
    public int minHeight(int windowHeight) {
        return heightWith(leastLanesHeight(windowHeight));
    }

    /** Returns the height of the lanes, pixels; 0 if they are hidden. */
    public int lanesHeight() {
        return scroll.isVisible() ? Math.max(0, getHeight() - aboveLanes()) : 0;
    }

    /**
     * Returns the height below a canvas that keeps at least half of the window, given the height of both, and that of
     * the window, pixels: with all rows of the lanes, or as many as there is room for.
     */
    public int heightIn(int stage, int window) {
        int most = Math.min(lanes.getPreferredScrollableViewportSize().height, maxLanesHeight(stage, window));
        return aboveLanes() + (scroll.isVisible() && most > 0 ? lanes.wholeRowsHeight(most) : 0);
    }

    /** Returns the height with a height of the lanes, pixels, if they are shown. */
    public int heightWith(int lanesHeight) {
        return aboveLanes() + (scroll.isVisible() ? lanesHeight : 0);
    }

    private int leastLanesHeight(int windowHeight) {
        return lanes.wholeRowsHeight((int) (MIN_WINDOW_SHARE * windowHeight));
    }

    private int maxLanesHeight(int stage, int window) {
        int least = leastLanesHeight(window);
        int room = stage - aboveLanes() - (window + 1) / 2;
        if (room >= least) {
            return room;
        }
        // Beside large instruments the canvas has less than half of the window anyway; then the lanes grow with their
        // text, as long as the canvas has half of what is left.
        int shared = Math.min(TextSize.scaled(least), stage / 2 - aboveLanes());
        return shared >= TextSize.scaled(LOWEST_LANES) ? shared : 0;
    }

    /** Returns the height of the slider and of what is around the lanes, pixels. */
    private int aboveLanes() {
        Insets insets = getInsets();
        return bar.getPreferredSize().height
                + (scroll.isVisible() ? TIME_SCROLL_HEIGHT - TIME_SCROLL_OVERLAP : 0)
                + insets.top
                + insets.bottom;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(
                bar.getPreferredSize().width, heightWith(lanes.getPreferredScrollableViewportSize().height));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(0, heightWith(lanes.getMinimumSize().height));
    }

    /**
     * Places the slider above the lanes, which end with a whole row, and below its track the scroll bar of the time.
     */
    @Override
    public void doLayout() {
        Insets insets = getInsets();
        int width = getWidth() - insets.left - insets.right;
        int sliderHeight = Math.min(bar.getPreferredSize().height, getHeight());
        bar.setBounds(insets.left, insets.top, width, sliderHeight);
        bar.validate();
        int top = insets.top + sliderHeight - TIME_SCROLL_OVERLAP;
        int trackLeft = insets.left + (int) bar.axis().left();
        timeScroll.setBounds(
                trackLeft, top, (int) (bar.axis().right() - bar.axis().left()) + 1, TIME_SCROLL_HEIGHT);
        int lanesTop = top + TIME_SCROLL_HEIGHT;
        int room = Math.max(0, getHeight() - insets.bottom - lanesTop);
        scroll.setBounds(insets.left, lanesTop, width, Math.min(room, lanes.wholeRowsHeight(room)));
    }
}
