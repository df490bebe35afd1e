package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.SnapSettings;

/** Pans the view; a click without a move leaves the view unchanged and calls a handler. */
public final class PanGesture implements Gesture {

    private final Viewport viewport;
    private final Vector2 pressed;
    private final Runnable click;
    private Vector2 last;
    private boolean moved;

    public PanGesture(Viewport viewport, Vector2 pressed, Runnable click) {
        this.viewport = viewport;
        this.pressed = pressed;
        this.click = click;
        this.last = pressed;
    }

    @Override
    public void moveTo(Vector2 screen, SnapSettings snap) {
        moved |= screen.distanceTo(pressed) >= CLICK_TOLERANCE;
        if (moved) {
            Vector2 by = screen.minus(last);
            viewport.moveCamera(camera -> camera.panned(by.x(), by.y()));
            last = screen;
        }
    }

    @Override
    public void release() {
        if (!moved) {
            click.run();
        }
    }
}
