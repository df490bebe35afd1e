package faultline.gui.timeline;

import faultline.gui.text.Messages;
import faultline.gui.theme.AccessibleComponent;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javax.accessibility.AccessibleRole;
import javax.swing.JViewport;
import javax.swing.Scrollable;

/** The lanes of the time line: one for each sensor, and one for everything else. */
public final class LaneView extends AccessibleComponent implements Scrollable {

    /** The bound property of the number of rows. */
    static final String ROWS_PROPERTY = "rows";

    private static final int RULER_HEIGHT = 14;

    private final transient TimelineEditor editor;
    private final transient LaneActions actions;
    private final transient LaneMouse mouse;
    private final transient LaneZoom zoom;
    /** The sensor for which a fault is asked when the lanes are updated, empty for none. */
    private String faultSensor = "";

    private transient List<Lane> allLanes = List.of(Lane.OTHER);
    /** Whether the lanes of another scenario will be shown next. */
    private boolean newScenario = true;
    /** The number of rows that the lanes take. */
    private int rowCount = 1;
    /** The layout that was used last, null before the first. */
    private transient LaneLayout layout;

    private transient TimelineModel model = TimelineModel.EMPTY;
    private double now;
    /** The present time at the last update without a drag, seconds. */
    private double followedNow;

    private int lane;
    /** The index of the selected item, or {@link LaneLayout#NONE}. */
    private int selection = LaneLayout.NONE;
    /** The preview of the dragged or new item; null if nothing is dragged. */
    private transient TimelineItem preview;

    /** Creates a view without a scenario; {@code editor} makes the changes. */
    LaneView(TimelineEditor editor) {
        super(AccessibleRole.LIST);
        this.editor = editor;
        setFocusable(true);
        setEnabled(false);
        setOpaque(true);
        setToolTipText("");
        RefreshSteps.add(this, LaneView::updateTexts);
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                describe();
            }

            @Override
            public void focusLost(FocusEvent event) {
                repaint();
            }
        });
        zoom = new LaneZoom(editor::tickLength);
        zoom.addListener(this::repaint);
        actions = new LaneActions(this, editor);
        mouse = new LaneMouse(this, editor, actions);
        mouse.install();
        new LaneKeys(this, actions, mouse).install();
    }

    private void updateTexts() {
        getAccessibleContext().setAccessibleName(Messages.get("timeline"));
        if (isFocusOwner()) {
            describe();
        }
        revalidate();
        repaint();
    }

    /** Shows lanes without items before there is a scenario. */
    void setEmptyLanes(List<Lane> newLanes, TimeAxis newAxis) {
        allLanes = List.copyOf(newLanes);
        zoom.alignWith(newAxis);
        countRows();
    }

    /** Aligns the lanes with the axis of the whole run; the part of it that is visible stays so. */
    void setAxis(TimeAxis whole) {
        zoom.alignWith(whole);
    }

    /**
     * Shows the scenario's timeline in lanes, given the axis of the whole run. If the present time leaves the visible
     * part, the lanes follow it, unless the mouse drags something in them.
     */
    void update(List<Lane> newLanes, TimeAxis newAxis, double newNow) {
        assert EventQueue.isDispatchThread();
        setEnabled(true);
        updateModel();
        setAxis(newAxis);
        boolean otherLanes = !newLanes.equals(allLanes);
        if (!mouse.isDragging()) {
            zoom.follow(followedNow, newNow);
            followedNow = newNow;
        }
        if (newNow != now) {
            now = newNow;
            repaint();
        }
        if (otherLanes) {
            setLanes(newLanes);
        }
        editor.takeRestored().ifPresent(this::select);
        if (!faultSensor.isEmpty()) {
            String sensor = faultSensor;
            faultSensor = "";
            EventQueue.invokeLater(() -> addFault(new Lane.SensorLane(sensor)));
        }
        if (newScenario) {
            newScenario = false;
            // When the lanes have their new height.
            EventQueue.invokeLater(this::showFirstItem);
        }
    }

    /** Shows other lanes; the selected one stays selected if it is among them. */
    private void setLanes(List<Lane> newLanes) {
        int kept = newScenario ? -1 : newLanes.indexOf(selectedLane());
        allLanes = List.copyOf(newLanes);
        lane = kept >= 0 ? kept : Math.min(lane, allLanes.size() - 1);
        countRows();
        repaint();
    }

    /** Gives the selected lane the id that its sensor has in the next lanes, as returned for the present one. */
    void renameSensors(UnaryOperator<String> presentId) {
        if (selectedLane() instanceof Lane.SensorLane sensor) {
            List<Lane> renamed = new ArrayList<>(allLanes);
            renamed.set(lane, new Lane.SensorLane(presentId.apply(sensor.id())));
            setLanes(renamed);
        }
    }

    /** Shows the newest timeline. If it is another one, a drag is cancelled: its item may no longer exist. */
    void updateModel() {
        TimelineModel newest = editor.model();
        if (newest != model) {
            Optional<TimelineItem> wanted = selectedItem();
            mouse.cancelDrag();
            model = newest;
            selection = wanted.map(editor::presentItem).map(this::indexOf).orElse(LaneLayout.NONE);
            countRows();
            repaint();
        }
    }

    /** Asks for a new fault of a sensor that starts at the present time, as soon as the lanes show. */
    public void addFault(String sensor) {
        faultSensor = sensor;
    }

    private void addFault(Lane wanted) {
        if (allLanes.contains(wanted)) {
            select(allLanes.indexOf(wanted), LaneLayout.NONE);
            actions.addItem(now);
        }
    }

    /**
     * Prepares for the lanes of another scenario, of which all of the run will be shown, and the first lane with an
     * item: uppermost if it is too low.
     */
    void startScenario() {
        mouse.cancelDrag();
        zoom.showAll();
        lane = 0;
        selection = LaneLayout.NONE;
        faultSensor = "";
        newScenario = true;
    }

    private void showFirstItem() {
        LaneLayout lanes = lanes();
        int height = getVisibleRect().height;
        int first = model.items().stream().mapToInt(lanes::laneOf).min().orElse(0);
        boolean shownFromTop = lanes.laneTop(first) + lanes.laneHeight(first) <= height;
        scrollRectToVisible(new Rectangle(0, shownFromTop ? 0 : lanes.laneTop(first) - lanes.top(), 1, height));
    }

    /** Returns the y coordinate of the upper edge of the ruler, which stays where it is when the lanes scroll. */
    int rulerTop() {
        return getVisibleRect().y;
    }

    /** Changes the height of the lanes with the number of items that overlap. */
    private void countRows() {
        int count = LaneLayout.rowCount(allLanes, shownItems());
        if (count != rowCount) {
            rowCount = count;
            revalidate();
            firePropertyChange(ROWS_PROPERTY, null, count);
        }
    }

    /** Returns whether a y coordinate is below the ruler, which covers lanes that are scrolled. */
    boolean isBelowRuler(int y) {
        return y >= rulerTop() + lanes().top();
    }

    /** Returns the item at a position; null if there is none or the ruler covers it. */
    LaneLayout.ItemHit hit(Point at) {
        return isBelowRuler(at.y) ? lanes().hit(at.x, at.y) : null;
    }

    /** Returns the places of lanes and items. */
    LaneLayout lanes() {
        List<TimelineItem> items = shownItems();
        int top = TextSize.scaled(RULER_HEIGHT);
        int height = rowHeight();
        if (layout == null || !layout.isOf(allLanes, items, axis(), top, height)) {
            layout = new LaneLayout(allLanes, items, axis(), top, height);
        }
        return layout;
    }

    private List<TimelineItem> shownItems() {
        if (preview == null) {
            return model.items();
        }
        List<TimelineItem> items = new ArrayList<>(model.items());
        if (selection == LaneLayout.NONE) {
            items.add(preview);
        } else {
            items.set(selection, preview);
        }
        return items;
    }

    private int rowHeight() {
        return rowFit(getParent() instanceof JViewport viewport ? viewport.getHeight() : getHeight())
                .rowHeight();
    }

    private RowFit rowFit(int height) {
        return RowFit.of(height - TextSize.scaled(RULER_HEIGHT), rowCount, RowFit.RowHeights.scaled());
    }

    /** Returns the greatest height that is at most a given one and shows whole rows, at least one, pixels. */
    int wholeRowsHeight(int room) {
        return TextSize.scaled(RULER_HEIGHT) + rowFit(room).height();
    }

    /** Returns the y coordinate nearest to a given one to which the lanes can scroll without cutting off a row. */
    int scrollPosition(int y) {
        int row = rowHeight();
        return (y + row / 2) / row * row;
    }

    /** Returns which part of the run is visible. */
    LaneZoom zoom() {
        return zoom;
    }

    TimeAxis axis() {
        return zoom.axis();
    }

    /** Returns the length of a tick, seconds. */
    double tickLength() {
        return editor.tickLength();
    }

    double now() {
        return now;
    }

    int lane() {
        return lane;
    }

    int selection() {
        return selection;
    }

    Optional<TimelineItem> selectedItem() {
        return selection == LaneLayout.NONE
                ? Optional.empty()
                : Optional.of(model.items().get(selection));
    }

    /** Returns whether keys or an open menu are for the selected lane. */
    boolean showsSelectedLane() {
        return isFocusOwner() || actions.isMenuShown();
    }

    Lane selectedLane() {
        return allLanes.get(lane);
    }

    List<Lane> allLanes() {
        return allLanes;
    }

    Optional<TimelineItem> preview() {
        return Optional.ofNullable(preview);
    }

    /** Sets what the selected item, or a new one if none is selected, will be when a drag ends; null ends the drag. */
    void setPreview(TimelineItem newPreview) {
        preview = newPreview;
        countRows();
        repaint();
    }

    /** Selects a lane and one of its items, or {@link LaneLayout#NONE}, and makes it visible. */
    void select(int newLane, int item) {
        lane = newLane;
        selection = item;
        selectedItem().ifPresent(zoom::showItem);
        describe();
    }

    /** Selects an item by its value after an edit; none if the timeline does not contain it. */
    void select(TimelineItem item) {
        preview = null;
        model = editor.model();
        countRows();
        selection = indexOf(item);
        selectLaneOfItem();
    }

    /** Returns the index of an item, or {@link LaneLayout#NONE} if the timeline does not contain it. */
    int indexOf(TimelineItem item) {
        return model.items().lastIndexOf(item);
    }

    private void selectLaneOfItem() {
        selectedItem().ifPresent(item -> {
            lane = lanes().laneOf(item);
            zoom.showItem(item);
        });
        describe();
    }

    /** Makes the selection visible, and readable for a screen reader. */
    private void describe() {
        getAccessibleContext()
                .setAccessibleDescription(selectedItem()
                        .map(item -> TimelineText.description(item, tickLength()))
                        .orElseGet(() -> Messages.get(
                                "timeline.lane",
                                selectedLane().label(),
                                Integer.toString(lanes().itemsIn(lane).size()))));
        LaneLayout lanes = lanes();
        // The ruler covers what is at the upper edge.
        scrollRectToVisible(
                new Rectangle(0, lanes.laneTop(lane) - lanes.top(), 1, lanes.top() + lanes.laneHeight(lane)));
        repaint();
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        LaneLayout lanes = lanes();
        LaneLayout.ItemHit hit = hit(event.getPoint());
        if (hit != null) {
            return TimelineText.description(lanes.items().get(hit.index()), tickLength());
        }
        boolean other = isBelowRuler(event.getY()) && lanes.laneAt(event.getY()) >= allLanes.size() - 1;
        return Messages.get(other ? "timeline.tip.other" : "timeline.tip");
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Antialiasing.paint(graphics, g -> new LanePainter(g, this).paint());
    }

    @Override
    public Dimension getPreferredSize() {
        boolean scrolled = getParent() instanceof JViewport viewport && viewport.getHeight() > 0;
        return height(
                rowCount, scrolled ? rowHeight() : RowFit.RowHeights.scaled().greatest());
    }

    @Override
    public Dimension getMinimumSize() {
        return height(1, RowFit.RowHeights.scaled().usual());
    }

    private static Dimension height(int rows, int rowHeight) {
        return new Dimension(0, TextSize.scaled(RULER_HEIGHT) + rows * rowHeight);
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return height(rowCount, RowFit.RowHeights.scaled().greatest());
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return rowHeight();
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return Math.max(1, (visible.height - TextSize.scaled(RULER_HEIGHT)) / rowHeight()) * rowHeight();
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent().getHeight() >= getPreferredSize().height;
    }
}
