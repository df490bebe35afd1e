package faultline.gui.instrument;

import java.awt.event.ActionEvent;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/**
 * What mouse and keys do to a strip chart: the wheel zooms on the pointer, a drag or the arrows go through time, and pointing reads out.
 */
final class StripHand extends MouseAdapter implements FocusListener {

    private static final double ZOOM = 1.25;
    private static final double STEP = 0.1;

    private final StripView view;
    private final Consumer<Boolean> hold;
    private int dragX;

    /** Acts on a view; to go through time, the chart is held by way of {@code hold}. */
    StripHand(StripView view, Consumer<Boolean> hold) {
        this.view = view;
        this.hold = hold;
    }

    void install() {
        view.addMouseListener(this);
        view.addMouseMotionListener(this);
        view.addMouseWheelListener(this);
        view.addFocusListener(this);
        bind("LEFT", () -> move(-STEP));
        bind("RIGHT", () -> move(STEP));
        bind("UP", () -> zoom(1 / ZOOM, 1));
        bind("DOWN", () -> zoom(ZOOM, 1));
        bind("END", () -> hold.accept(false));
    }

    private void bind(String key, Runnable action) {
        view.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(key), key);
        view.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    private void zoom(double factor, double share) {
        view.setSpan(view.span().scaled(factor, share));
    }

    private void move(double share) {
        hold.accept(true);
        view.setSpan(view.span().moved(share));
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        zoom(Math.pow(ZOOM, event.getPreciseWheelRotation()), view.share(event.getX()));
    }

    @Override
    public void mousePressed(MouseEvent event) {
        view.requestFocusInWindow();
        dragX = event.getX();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        move(view.share(dragX) - view.share(event.getX()));
        dragX = event.getX();
        mouseMoved(event);
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        view.point(OptionalDouble.of(event.getX()));
    }

    @Override
    public void mouseExited(MouseEvent event) {
        view.point(OptionalDouble.empty());
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
