package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.edit.Snap;
import faultline.paint.Brush;
import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.swing.SwingUtilities;

/**
 * What the mouse does. The wheel zooms on the cursor and the middle button pans. The left button does what the tool does, or else what
 * {@link Grips} finds: it moves, turns, resizes, selects, and pans where nothing is. The right button turns, or asks for a menu.
 */
final class Hand extends MouseAdapter {

    /** One notch of the wheel zooms by this factor. */
    private static final double NOTCH = 1.15;

    private final Viewpoint viewpoint;
    private final Grips grips;
    private final Watchers watchers;
    private final Watched<Optional<Vec>> cursor = new Watched<>(Optional.empty());
    private final Watched<Optional<Tool>> tool = new Watched<>(Optional.empty());
    private Optional<Hold> hold = Optional.empty();
    private Vec pressed = Vec.ZERO;
    /** The button that holds. */
    private int button;
    private Snap snap = Snap.NONE;

    Hand(Viewpoint viewpoint, Grips grips, Watchers watchers) {
        this.viewpoint = viewpoint;
        this.grips = grips;
        this.watchers = watchers;
    }

    /** The point of the world under the mouse. */
    Watched<Optional<Vec>> cursor() {
        return cursor;
    }

    /** What the left button does in place of selecting and moving. */
    Watched<Optional<Tool>> tool() {
        return tool;
    }

    /** Asks for a menu where the mouse was last, for those who have no right button at hand. */
    void askForMenu() {
        watchers.menu(new Point((int) pressed.x(), (int) pressed.y()));
    }

    void setSnap(Snap newSnap) {
        snap = newSnap;
    }

    /** Cancels what is going on; says whether there was anything. */
    boolean cancel() {
        boolean busy = hold.isPresent() || tool.get().isPresent();
        hold.ifPresent(Hold::cancel);
        hold = Optional.empty();
        tool.set(Optional.empty());
        return busy;
    }

    /** Lets go of what is no longer there. */
    void frameShown() {
        if (hold.filter(Hold::isLost).isPresent()) {
            hold.ifPresent(Hold::release);
            hold = Optional.empty();
        }
    }

    void paint(Brush brush) {
        hold.ifPresent(held -> held.paint(brush));
        tool.get().ifPresent(t -> t.paint(brush));
    }

    @Override
    public void mousePressed(MouseEvent event) {
        event.getComponent().requestFocusInWindow();
        if (hold.isPresent()) {
            return;
        }
        pressed = place(event);
        button = event.getButton();
        boolean left = SwingUtilities.isLeftMouseButton(event);
        if (SwingUtilities.isMiddleMouseButton(event)) {
            hold = Optional.of(new PanHold(viewpoint, pressed, () -> { }));
        } else if (tool.get().isPresent()) {
            useTool(event, left);
        } else {
            hold = Optional.of(grips.take(pressed, left, !left || event.isControlDown(), event.isShiftDown()));
        }
    }

    /** The right button says that there is no more to come. */
    private void useTool(MouseEvent event, boolean left) {
        Vec at = snapped(event);
        tool.get().ifPresent(left ? t -> t.press(at, event.getClickCount() > 1) : Tool::finish);
        endTool();
        event.getComponent().repaint();
    }

    /** Ends the tool where it has done what it is for. */
    void endTool() {
        tool.set(tool.get().filter(t -> !t.isDone()));
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        hold.ifPresent(held -> held.to(place(event), snap(event)));
        if (hold.isEmpty() && SwingUtilities.isLeftMouseButton(event)) {
            tool.get().ifPresent(t -> t.move(snapped(event), true));
        }
        cursor.set(Optional.of(world(place(event))));
        event.getComponent().repaint();
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        if (hold.isPresent() && event.getButton() != button) {
            return;
        }
        hold.ifPresent(Hold::release);
        if (hold.isEmpty() && SwingUtilities.isLeftMouseButton(event)) {
            tool.get().ifPresent(t -> t.release(snapped(event)));
            endTool();
        }
        boolean clicked = place(event).distanceTo(pressed) < Hold.CLICK;
        if (hold.isPresent() && clicked && SwingUtilities.isRightMouseButton(event)) {
            watchers.menu(event.getPoint());
        }
        hold = Optional.empty();
        event.getComponent().repaint();
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        Vec at = place(event);
        cursor.set(Optional.of(world(at)));
        tool.get().ifPresent(t -> {
            t.move(snapped(event), false);
            event.getComponent().repaint();
        });
        int shape = tool.get().isPresent() ? Cursor.CROSSHAIR_CURSOR : grips.cursor(at);
        event.getComponent().setCursor(Cursor.getPredefinedCursor(shape));
    }

    @Override
    public void mouseExited(MouseEvent event) {
        cursor.set(Optional.empty());
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        Vec at = place(event);
        viewpoint.move(camera -> camera.zoomedAbout(at, Math.pow(NOTCH, -event.getPreciseWheelRotation())));
    }

    /** Alt lets the hand go free for as long as it is down. */
    private Snap snap(MouseEvent event) {
        return event.isAltDown() ? Snap.NONE : snap;
    }

    private Vec snapped(MouseEvent event) {
        return snap(event).place(world(place(event)));
    }

    private Vec world(Vec at) {
        return viewpoint.camera().get().toWorld(at);
    }

    private static Vec place(MouseEvent event) {
        return new Vec(event.getX(), event.getY());
    }
}
