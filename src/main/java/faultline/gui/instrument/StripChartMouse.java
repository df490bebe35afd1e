package faultline.gui.instrument;

import faultline.gui.theme.KeyBindings;
import java.awt.Point;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/**
 * The mouse and keyboard input of a strip chart: the wheel zooms at the cursor, dragging and the arrow keys scroll
 * through time, and the cursor shows values. With Ctrl the mouse acts on the vertical axis, and with Shift or Ctrl the
 * keys act on it or move the cursor.
 */
final class StripChartMouse extends MouseAdapter implements FocusListener {

    private static final double ZOOM_FACTOR = 1.25;
    private static final double PAN_STEP = 0.1;
    private static final double HALF = 0.5;

    private final StripView view;
    private final Consumer<Boolean> freezeHandler;
    private final Consumer<Point> menuHandler;
    private int dragX;
    private int dragY;

    /** Creates the input handler of a view; {@code hold} holds or releases the chart, {@code menu} opens its menu. */
    StripChartMouse(StripView view, Consumer<Boolean> hold, Consumer<Point> menu) {
        this.view = view;
        this.freezeHandler = hold;
        this.menuHandler = menu;
    }

    void install() {
        view.addMouseListener(this);
        view.addMouseMotionListener(this);
        view.addMouseWheelListener(this);
        view.addFocusListener(this);
        bindKey("LEFT", () -> panBy(-PAN_STEP));
        bindKey("RIGHT", () -> panBy(PAN_STEP));
        bindKey("UP", () -> zoom(1 / ZOOM_FACTOR, 1));
        bindKey("DOWN", () -> zoom(ZOOM_FACTOR, 1));
        bindKey("menu UP", () -> view.zoomValues(1 / ZOOM_FACTOR, HALF));
        bindKey("menu DOWN", () -> view.zoomValues(ZOOM_FACTOR, HALF));
        bindKey("shift UP", () -> view.moveValues(PAN_STEP));
        bindKey("shift DOWN", () -> view.moveValues(-PAN_STEP));
        bindKey("shift LEFT", () -> view.movePointer(-1, 0));
        bindKey("shift RIGHT", () -> view.movePointer(1, 0));
        bindKey("menu LEFT", () -> view.movePointer(-1, PAN_STEP));
        bindKey("menu RIGHT", () -> view.movePointer(1, PAN_STEP));
        KeyBindings.bind(view, "ESCAPE", view::hasPointer, view::removePointer);
        bindKey("END", () -> freezeHandler.accept(false));
        bindKey("shift F10", this::showMenuAtCentre);
        bindKey("CONTEXT_MENU", this::showMenuAtCentre);
    }

    private void bindKey(String key, Runnable action) {
        KeyBindings.bind(view, key, action);
    }

    private void zoom(double factor, double share) {
        view.setSpan(view.span().zoomed(factor, share));
    }

    private void panBy(double share) {
        freezeHandler.accept(true);
        view.setSpan(view.span().moved(share));
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        double factor = Math.pow(ZOOM_FACTOR, event.getPreciseWheelRotation());
        if (event.isControlDown()) {
            view.zoomValues(factor, view.valueShareAt(event.getY()));
        } else {
            zoom(factor, view.shareAt(event.getX()));
        }
    }

    @Override
    public void mousePressed(MouseEvent event) {
        view.requestFocusInWindow();
        dragX = event.getX();
        dragY = event.getY();
        showMenuIfRequested(event);
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        showMenuIfRequested(event);
    }

    private void showMenuIfRequested(MouseEvent event) {
        if (event.isPopupTrigger()) {
            menuHandler.accept(event.getPoint());
        }
    }

    private void showMenuAtCentre() {
        menuHandler.accept(new Point(view.getWidth() / 2, view.getHeight() / 2));
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (SwingUtilities.isRightMouseButton(event)) {
            return;
        }
        if (event.isControlDown()) {
            view.moveValues(view.valueShareAt(dragY) - view.valueShareAt(event.getY()));
        } else {
            panBy(view.shareAt(dragX) - view.shareAt(event.getX()));
        }
        dragX = event.getX();
        dragY = event.getY();
        mouseMoved(event);
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        view.setPointer(event.getX());
    }

    @Override
    public void mouseExited(MouseEvent event) {
        view.removePointer();
    }

    @Override
    public void focusGained(FocusEvent event) {
        view.repaint();
    }

    @Override
    public void focusLost(FocusEvent event) {
        view.repaint();
    }
}
