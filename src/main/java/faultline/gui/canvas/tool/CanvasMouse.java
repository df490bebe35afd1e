package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.Rounding;
import faultline.gui.edit.SnapSettings;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/**
 * Handles the mouse. The wheel zooms at the cursor and the middle button pans. The left button uses the active tool, or
 * starts the gesture that {@link GesturePicker} picks: moving, rotating, resizing, selecting or panning. The right
 * button rotates, or requests a menu.
 */
public final class CanvasMouse extends MouseAdapter {

    /** The zoom factor of one notch of the wheel. */
    private static final double WHEEL_ZOOM_FACTOR = 1.15;
    /** One notch of the wheel pans by this distance. */
    private static final double WHEEL_PAN_PIXELS = 60;
    /** A horizontal wheel presses this button or the next one on X11; elsewhere it turns the wheel with Shift. */
    private static final int HORIZONTAL_WHEEL_LEFT = 4;

    private final Viewport viewport;
    private final GesturePicker gesturePicker;
    private final CanvasListeners listeners;
    private final ObservableValue<Optional<Vector2>> cursorPoint = new ObservableValue<>(Optional.empty());
    private final ObservableValue<Optional<Tool>> tool = new ObservableValue<>(Optional.empty());
    /** Null if no button is down. */
    private Gesture gesture;

    private Vector2 pressPoint = Vector2.ZERO;
    /** The button that has started the gesture. */
    private int button;
    /** The last point at which the left button was down for the tool, in the world; null if it is up. */
    private Vector2 toolPoint;

    private SnapSettings snap = SnapSettings.NONE;
    /** Whether keys have moved or set the point of the tool since the mouse was moved. */
    private boolean keyed;
    /** The point of the world under the mouse; null while the mouse is elsewhere. */
    private Vector2 mousePoint;

    public CanvasMouse(Viewport viewport, GesturePicker gesturePicker, CanvasListeners listeners) {
        this.viewport = viewport;
        this.gesturePicker = gesturePicker;
        this.listeners = listeners;
        tool.addListener(changed -> {
            toolPoint = null;
            if (changed.isEmpty() && keyed) {
                keyed = false;
                setMousePoint(mousePoint);
            }
        });
    }

    /** Adds the listeners to the canvas. */
    public void install(JComponent canvas) {
        canvas.addMouseListener(this);
        canvas.addMouseMotionListener(this);
        canvas.addMouseWheelListener(this);
        canvas.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                if (event.isTemporary() && event.getOppositeComponent() != null) {
                    completeDrag();
                    canvas.repaint();
                }
            }
        });
    }

    /** Returns the point of the world under the mouse, or the point of the active tool that keys have set. */
    public ObservableValue<Optional<Vector2>> cursorPoint() {
        return cursorPoint;
    }

    /** Returns the active tool, which the left button uses. */
    ObservableValue<Optional<Tool>> tool() {
        return tool;
    }

    /** Asks for a menu for users without a right button: at what is selected, or where the mouse was pressed last. */
    void requestMenu() {
        Vector2 at = gesturePicker.selectedPoint().orElse(pressPoint);
        listeners.fireMenuRequested(new Point((int) at.x(), (int) at.y()));
    }

    void setSnap(SnapSettings newSnap) {
        snap = newSnap;
    }

    /** Cancels the gesture and the tool; returns whether there was one. */
    boolean cancel() {
        boolean busy = isGestureActive() || tool.get().isPresent();
        cancelGesture();
        tool.set(Optional.empty());
        return busy;
    }

    boolean isGestureActive() {
        return gesture != null;
    }

    void cancelGesture() {
        if (gesture != null) {
            gesture.cancel();
            gesture = null;
        }
    }

    /** Lets the gesture follow a change of the ids of obstacles. */
    void renameObstacles(UnaryOperator<String> nextId) {
        if (gesture != null) {
            gesture.renameObstacles(nextId);
        }
    }

    /** Ends a gesture whose objects no longer exist. */
    public void releaseIfTargetGone() {
        if (gesture != null && gesture.isTargetGone()) {
            discardGesture();
        }
    }

    private void discardGesture() {
        if (gesture != null) {
            gesture.discard();
            gesture = null;
        }
    }

    /** Ends the gesture and the tool, which are about another scenario than the one that is open now. */
    void startScenario() {
        discardGesture();
        tool.set(Optional.empty());
    }

    public void paint(DrawContext context) {
        if (gesture != null) {
            gesture.paint(context);
        }
        tool.get().ifPresent(t -> {
            t.paint(context);
            if (keyed) {
                InteractionPainter.paintSketch(context, List.of(keyPoint()), false);
            }
        });
    }

    @Override
    public void mousePressed(MouseEvent event) {
        event.getComponent().requestFocusInWindow(FocusEvent.Cause.MOUSE_EVENT);
        boolean left = SwingUtilities.isLeftMouseButton(event);
        if (event.getButton() == button || left && toolPoint != null) {
            completeDrag();
        }
        if (gesture != null) {
            return;
        }
        if (event.getButton() > MouseEvent.BUTTON3) {
            panByWheel(event.getButton() == HORIZONTAL_WHEEL_LEFT ? -1 : 1);
            return;
        }
        pressPoint = screenPoint(event);
        button = event.getButton();
        if (SwingUtilities.isMiddleMouseButton(event)) {
            gesture = new PanGesture(viewport, pressPoint, () -> {});
        } else if (tool.get().isPresent()) {
            useTool(event, left);
        } else {
            gesture = gesturePicker.pick(pressPoint, left, !left || event.isControlDown(), event.isShiftDown());
        }
    }

    /** Uses the tool; the right button completes it. */
    private void useTool(MouseEvent event, boolean left) {
        Vector2 at = snappedPoint(event);
        toolPoint = left ? at : toolPoint;
        tool.get().ifPresent(left ? t -> t.press(at, event.getClickCount() > 1) : Tool::finish);
        clearFinishedTool();
        event.getComponent().repaint();
    }

    /** Deactivates the tool if it is done. */
    void clearFinishedTool() {
        tool.set(tool.get().filter(t -> !t.isDone()));
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (gesture != null) {
            gesture.moveTo(screenPoint(event), snap(event));
        } else if (SwingUtilities.isLeftMouseButton(event)) {
            toolPoint = snappedPoint(event);
            tool.get().ifPresent(t -> t.move(toolPoint, true));
        }
        setMousePoint(toWorld(screenPoint(event)));
        event.getComponent().repaint();
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        if (gesture != null && event.getButton() != button) {
            return;
        }
        boolean clicked = screenPoint(event).distanceTo(pressPoint) < Gesture.CLICK_TOLERANCE;
        boolean menu = gesture != null && clicked && SwingUtilities.isRightMouseButton(event);
        if (gesture != null) {
            completeGesture();
        } else if (toolPoint != null && SwingUtilities.isLeftMouseButton(event)) {
            toolPoint = snappedPoint(event);
            releaseTool();
        }
        if (menu) {
            listeners.fireMenuRequested(event.getPoint());
        }
        event.getComponent().repaint();
    }

    /**
     * Completes a gesture or a drag of the tool. The canvas does not get the release of a button while a dialog is
     * open, so the focus of the dialog completes a drag, too, and so does a movement without a button.
     */
    private void completeDrag() {
        completeGesture();
        releaseTool();
    }

    private void completeGesture() {
        if (gesture != null) {
            gesture.release();
            gesture = null;
        }
    }

    private void releaseTool() {
        if (toolPoint != null) {
            Vector2 at = toolPoint;
            toolPoint = null;
            tool.get().ifPresent(t -> t.release(at));
            clearFinishedTool();
        }
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        completeDrag();
        keyed = false;
        Vector2 at = screenPoint(event);
        setMousePoint(toWorld(at));
        tool.get().ifPresent(t -> {
            t.move(snappedPoint(event), false);
            event.getComponent().repaint();
        });
        int shape = tool.get().isPresent() ? Cursor.CROSSHAIR_CURSOR : gesturePicker.cursorType(at);
        event.getComponent().setCursor(Cursor.getPredefinedCursor(shape));
    }

    @Override
    public void mouseExited(MouseEvent event) {
        setMousePoint(null);
    }

    private void setMousePoint(Vector2 pointOrNull) {
        mousePoint = pointOrNull;
        cursorPoint.set(Optional.ofNullable(pointOrNull));
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        if (event.isShiftDown()) {
            panByWheel(event.getPreciseWheelRotation());
            return;
        }
        viewport.zoomAbout(screenPoint(event), Math.pow(WHEEL_ZOOM_FACTOR, -event.getPreciseWheelRotation()));
    }

    /** Pans horizontally by notches of the wheel, positive to the right. */
    private void panByWheel(double notches) {
        viewport.moveCamera(camera -> camera.panned(-notches * WHEEL_PAN_PIXELS, 0));
    }

    /** Returns the point at which a tool acts by key: the cursor, or the centre of the view. */
    Vector2 keyPoint() {
        return snap.point(unsnappedKeyPoint());
    }

    private Vector2 unsnappedKeyPoint() {
        Camera camera = viewport.camera().get();
        return cursorPoint.get().orElseGet(() -> Rounding.round(new Vector2(camera.x(), camera.y())));
    }

    /** Moves the point of the active tool, metres; without a tool, moves the view to the side of the step instead. */
    void moveKeyPoint(Vector2 step, double pixels) {
        if (tool.get().isEmpty()) {
            Vector2 side = step.times(-pixels / step.length());
            viewport.moveCamera(camera -> camera.panned(side.x(), -side.y()));
            return;
        }
        keyed = true;
        cursorPoint.set(Optional.of(Rounding.round(unsnappedKeyPoint().plus(step))));
        tool.get().ifPresent(t -> t.moveByKey(keyPoint()));
    }

    /** Uses the active tool at its point, as a click does. */
    void clickKeyPoint() {
        if (tool.get().isEmpty()) {
            return;
        }
        keyed = true;
        Vector2 at = keyPoint();
        cursorPoint.set(Optional.of(at));
        tool.get().ifPresent(t -> {
            t.press(at, false);
            t.release(at);
        });
        clearFinishedTool();
    }

    /** Returns the snap settings; Alt turns them off while it is held. */
    private SnapSettings snap(MouseEvent event) {
        return event.isAltDown() ? SnapSettings.NONE : snap;
    }

    private Vector2 snappedPoint(MouseEvent event) {
        return snap(event).point(toWorld(screenPoint(event)));
    }

    private Vector2 toWorld(Vector2 at) {
        return viewport.camera().get().toWorld(at);
    }

    private static Vector2 screenPoint(MouseEvent event) {
        return new Vector2(event.getX(), event.getY());
    }
}
