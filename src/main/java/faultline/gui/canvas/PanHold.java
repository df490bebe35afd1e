package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.edit.Snap;

/** A pan from where the button went down; one that goes nowhere is a click, and leaves the view as it is. */
final class PanHold implements Hold {

    private final Viewpoint viewpoint;
    private final Vec pressed;
    private final Runnable click;
    private Vec last;
    private boolean moved;

    PanHold(Viewpoint viewpoint, Vec pressed, Runnable click) {
        this.viewpoint = viewpoint;
        this.pressed = pressed;
        this.click = click;
        this.last = pressed;
    }

    @Override
    public void to(Vec screen, Snap snap) {
        moved |= screen.distanceTo(pressed) >= CLICK;
        if (moved) {
            Vec by = screen.minus(last);
            viewpoint.move(camera -> camera.panned(by.x(), by.y()));
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
