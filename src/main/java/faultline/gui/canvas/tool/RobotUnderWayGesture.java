package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.SnapSettings;
import faultline.gui.text.Messages;

/** A drag of a robot that has started, which cannot be moved: a note says so. A click calls a handler. */
public final class RobotUnderWayGesture implements Gesture {

    private final Vector2 pressed;
    private final CanvasListeners listeners;
    private final Runnable click;
    private boolean moved;

    public RobotUnderWayGesture(Vector2 pressed, CanvasListeners listeners, Runnable click) {
        this.pressed = pressed;
        this.listeners = listeners;
        this.click = click;
    }

    @Override
    public void moveTo(Vector2 screen, SnapSettings snap) {
        if (!moved && screen.distanceTo(pressed) >= CLICK_TOLERANCE) {
            moved = true;
            listeners.fireNote(Messages.get("start.underWay"), world -> world.tick() > 0);
        }
    }

    @Override
    public void release() {
        if (!moved) {
            click.run();
        }
    }
}
