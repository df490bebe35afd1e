package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.paint.Brush;
import faultline.paint.Camera;
import faultline.paint.SelectionPainter;
import faultline.world.Obstacle;
import java.awt.Cursor;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.swing.SwingUtilities;

/**
 * What the mouse does. The wheel zooms on the cursor. The left button moves an obstacle, turns the selected one by its handle, and
 * pans where nothing is; the right button, or the left one with Ctrl, turns; the middle button pans anywhere. A click selects.
 */
final class Hand extends MouseAdapter {

    /** One notch of the wheel zooms by this factor. */
    private static final double NOTCH = 1.15;

    private final Scene scene;
    private final Viewpoint viewpoint;
    private final ObstacleMover mover;
    private final Watched<Optional<Vec>> cursor = new Watched<>(Optional.empty());
    private Optional<DragInProgress> drag = Optional.empty();
    private Optional<Pan> pan = Optional.empty();

    /** A pan from where the button went down; the place where the mouse was last goes along. */
    private record Pan(Vec pressed, Vec last, boolean clickClears) {
        Pan at(Vec now) {
            return new Pan(pressed, now, clickClears && now.distanceTo(pressed) < DragInProgress.CLICK);
        }
    }

    Hand(Scene scene, Viewpoint viewpoint, ObstacleMover mover) {
        this.scene = scene;
        this.viewpoint = viewpoint;
        this.mover = mover;
    }

    /** The point of the world under the mouse. */
    Watched<Optional<Vec>> cursor() {
        return cursor;
    }

    /** Cancels the drag that is going on; says whether there was one. */
    boolean cancel() {
        drag.ifPresent(DragInProgress::cancel);
        boolean cancelled = drag.isPresent();
        letGo();
        return cancelled;
    }

    private void letGo() {
        drag.ifPresent(d -> mover.end());
        drag = Optional.empty();
    }

    /** Lets go of an obstacle that is no longer there. */
    void frameShown() {
        if (drag.filter(d -> scene.obstacle(d.obstacle()).isEmpty()).isPresent()) {
            letGo();
        }
    }

    void paint(Brush brush) {
        drag.ifPresent(d -> d.paint(brush));
    }

    @Override
    public void mousePressed(MouseEvent event) {
        event.getComponent().requestFocusInWindow();
        if (drag.isPresent() || pan.isPresent()) {
            return;
        }
        Vec at = place(event);
        Optional<Obstacle> under = under(at);
        boolean left = SwingUtilities.isLeftMouseButton(event);
        if (left && onHandle(at)) {
            start(new Drag.Turn(scene.selected().orElseThrow(), world(at)), at);
        } else if (under.isPresent() && !SwingUtilities.isMiddleMouseButton(event)) {
            boolean turns = !left || event.isControlDown();
            scene.selection().set(under.map(Obstacle::id));
            start(turns ? new Drag.Turn(under.get(), world(at)) : new Drag.Move(under.get(), world(at)), at);
        } else {
            pan = Optional.of(new Pan(at, at, left));
        }
    }

    private void start(Drag started, Vec at) {
        mover.begin();
        drag = Optional.of(new DragInProgress(started, at, mover));
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        Vec at = place(event);
        drag.ifPresent(d -> d.to(at, world(at)));
        pan.ifPresent(p -> viewpoint.move(camera -> camera.panned(at.x() - p.last().x(), at.y() - p.last().y())));
        pan = pan.map(p -> p.at(at));
        cursor.set(Optional.of(world(at)));
        event.getComponent().repaint();
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        if (pan.filter(Pan::clickClears).isPresent()) {
            scene.selection().set(Optional.empty());
        }
        letGo();
        pan = Optional.empty();
        event.getComponent().repaint();
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        Vec at = place(event);
        cursor.set(Optional.of(world(at)));
        event.getComponent().setCursor(Cursor.getPredefinedCursor(shape(at)));
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

    private int shape(Vec at) {
        if (onHandle(at)) {
            return Cursor.HAND_CURSOR;
        }
        return under(at).isPresent() ? Cursor.MOVE_CURSOR : Cursor.DEFAULT_CURSOR;
    }

    private boolean onHandle(Vec at) {
        double reach = SelectionPainter.HANDLE_RADIUS + DragInProgress.CLICK;
        return scene.selected().filter(obstacle -> SelectionPainter.handle(camera(), obstacle).distanceTo(at) <= reach).isPresent();
    }

    private Optional<Obstacle> under(Vec at) {
        return ObstacleFinder.at(camera(), scene.obstacles(), at);
    }

    private Vec world(Vec at) {
        return camera().toWorld(at);
    }

    private Camera camera() {
        return viewpoint.camera().get();
    }

    private static Vec place(MouseEvent event) {
        return new Vec(event.getX(), event.getY());
    }
}
