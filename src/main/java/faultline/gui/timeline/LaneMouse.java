package faultline.gui.timeline;

import java.awt.Cursor;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.swing.SwingUtilities;

/**
 * The mouse on the lanes: a drag in a lane draws a fault, a drag of a bar or a mark moves it, also to another lane that
 * can have it, a drag of a bar's end moves the end. A double click edits, or adds a fault or a change of the
 * controller. The wheel zooms in time with Ctrl and moves in time with Shift, as the middle button does; otherwise it
 * scrolls the lanes.
 */
final class LaneMouse extends MouseAdapter {

    private static final int DRAG_DISTANCE = 4;
    /** One notch of the wheel moves in time by this distance, pixels. */
    private static final double WHEEL_PIXELS = 60;
    /** A horizontal wheel presses this button or the next one on X11; elsewhere it turns the wheel with Shift. */
    private static final int HORIZONTAL_WHEEL_LEFT = 4;

    private final LaneView view;
    private final TimelineEditor editor;
    private final LaneActions actions;
    /** The press of the left button; null while it is up, and after Escape. */
    private MouseEvent pressed;
    /** The time at that press, which may have been scrolled out of view since, seconds. */
    private double pressedTime;
    /** The lanes at that press: those with a preview may have other heights. */
    private LaneLayout pressedLanes;
    /** Whether the mouse has been moved in time since that press. */
    private boolean movedInTime;
    /** The last x coordinate of the mouse while the middle button moves the lanes in time. */
    private int panX;

    /** The item at the last press of a button; null if there was none. */
    private LaneLayout.ItemHit hit;

    LaneMouse(LaneView view, TimelineEditor editor, LaneActions actions) {
        this.view = view;
        this.editor = editor;
        this.actions = actions;
    }

    void install() {
        view.addMouseListener(this);
        view.addMouseMotionListener(this);
        view.addMouseWheelListener(this);
        view.addFocusListener(new FocusAdapter() {
            // The lanes do not get the release of a button while a dialog is open.
            @Override
            public void focusLost(FocusEvent event) {
                if (event.isTemporary() && event.getOppositeComponent() != null) {
                    cancelDrag();
                }
            }
        });
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        if (!view.isEnabled()) {
            return;
        }
        if (event.isControlDown()) {
            view.zoom().zoom(-event.getPreciseWheelRotation(), event.getX());
        } else if (event.isShiftDown()) {
            view.zoom().move(event.getPreciseWheelRotation() * WHEEL_PIXELS);
        } else {
            view.getParent().dispatchEvent(SwingUtilities.convertMouseEvent(view, event, view.getParent()));
        }
    }

    @Override
    public void mousePressed(MouseEvent event) {
        if (event.getButton() > MouseEvent.BUTTON3) {
            view.zoom().move(event.getButton() == HORIZONTAL_WHEEL_LEFT ? -WHEEL_PIXELS : WHEEL_PIXELS);
            return;
        }
        if (SwingUtilities.isMiddleMouseButton(event)) {
            panX = event.getX();
            return;
        }
        // Another button must not change what is being dragged.
        if (!view.isEnabled() || isDragging() || !view.isBelowRuler(event.getY())) {
            return;
        }
        view.requestFocusInWindow();
        view.updateModel();
        LaneLayout lanes = view.lanes();
        hit = view.hit(event.getPoint());
        int lane = hit == null
                ? lanes.laneAt(event.getY())
                : lanes.laneOf(lanes.items().get(hit.index()));
        if (lane != LaneLayout.NONE) {
            view.select(lane, hit == null ? LaneLayout.NONE : hit.index());
            pressed = SwingUtilities.isLeftMouseButton(event) && !event.isPopupTrigger() ? event : null;
            pressedTime = view.axis().timeAt(event.getX());
            pressedLanes = lanes;
            movedInTime = false;
        }
        showMenuIfWanted(event);
    }

    /** The press of a button asks for a menu on some systems, its release on others. */
    private void showMenuIfWanted(MouseEvent event) {
        if (event.isPopupTrigger() && view.isEnabled() && view.isBelowRuler(event.getY())) {
            actions.showMenu(view, event.getX(), event.getY(), snapped(event.getX()));
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (SwingUtilities.isMiddleMouseButton(event)) {
            view.zoom().move(panX - event.getX());
            panX = event.getX();
            return;
        }
        view.updateModel();
        if (pressed == null) {
            return;
        }
        movedInTime |= Math.abs(event.getX() - pressed.getX()) >= DRAG_DISTANCE;
        if (movedInTime || isDragging() || isInAnotherLane(event.getY())) {
            scrollTo(event.getX());
            dragged(event).ifPresent(view::setPreview);
        }
    }

    /** Returns whether the whole selected item is held and can be in another lane, at a y coordinate. */
    private boolean isInAnotherLane(int y) {
        return hit != null
                && hit.part() == LaneLayout.ItemPart.BODY
                && view.selectedItem()
                        .filter(item -> !inLaneAt(y, item).equals(item))
                        .isPresent();
    }

    /** Returns an item in the lane at a y coordinate, or an equal one if it cannot be there. */
    private TimelineItem inLaneAt(int y, TimelineItem item) {
        int lane = pressedLanes.laneAt(y);
        return lane == LaneLayout.NONE ? item : item.inLane(pressedLanes.lanes().get(lane));
    }

    /** Moves the lanes in time by the distance of the mouse from the visible part, so that a drag can continue. */
    private void scrollTo(int x) {
        TimeAxis axis = view.axis();
        view.zoom().move(Math.min(0, x - axis.left()) + Math.max(0, x - axis.right()));
    }

    private Optional<TimelineItem> dragged(MouseEvent event) {
        double from = snap(pressedTime);
        double to = snapped(event.getX());
        if (hit == null) {
            return actions.newFault(Math.min(from, to), Math.max(from, to))
                    .map(item -> actions.withEnds(item, item.start(), item.end()));
        }
        double by = view.axis().timeAt(event.getX()) - pressedTime;
        return view.selectedItem().map(item -> switch (hit.part()) {
            case START -> actions.withEnds(item, snap(item.start() + by), item.end());
            case END -> actions.withEnds(item, item.start(), to);
            case BODY -> {
                double start = movedInTime ? snap(Math.max(0, item.start() + by)) : item.start();
                yield actions.withEnds(inLaneAt(event.getY(), item), start, item.end() + start - item.start());
            }
        });
    }

    private double snapped(double x) {
        return snap(view.axis().timeAt(x));
    }

    private double snap(double time) {
        double step = actions.step();
        return editor.roundToTick(Math.round(Math.max(0, time) / step) * step);
    }

    boolean isDragging() {
        return view.preview().isPresent();
    }

    void cancelDrag() {
        pressed = null;
        view.setPreview(null);
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        if (pressed != null && event.getButton() != pressed.getButton()) {
            return;
        }
        view.updateModel();
        pressed = null;
        view.preview().ifPresent(this::commit);
        showMenuIfWanted(event);
    }

    private void commit(TimelineItem item) {
        if (view.selection() == LaneLayout.NONE) {
            actions.add(item);
        } else {
            editor.replace(view.selection(), item);
            view.select(item);
        }
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        if (view.isEnabled()
                && SwingUtilities.isLeftMouseButton(event)
                && event.getClickCount() == 2
                && view.isBelowRuler(event.getY())
                && view.lanes().laneAt(event.getY()) != LaneLayout.NONE) {
            if (hit == null) {
                actions.addItem(snapped(event.getX()));
            } else {
                actions.editOrAdd();
            }
        }
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        if (pressed != null) {
            // The button has been released elsewhere.
            cancelDrag();
        }
        LaneLayout.ItemHit under = view.hit(event.getPoint());
        boolean edge = under != null && under.part() != LaneLayout.ItemPart.BODY;
        view.setCursor(Cursor.getPredefinedCursor(
                edge ? Cursor.E_RESIZE_CURSOR : under == null ? Cursor.DEFAULT_CURSOR : Cursor.HAND_CURSOR));
    }
}
