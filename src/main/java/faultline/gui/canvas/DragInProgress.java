package faultline.gui.canvas;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.Brush;
import faultline.paint.SelectionPainter;
import java.util.Optional;

/** One drag of an obstacle from the press of the button on: nothing happens before the mouse has moved far enough to mean it. */
final class DragInProgress {

    /** A mouse that moves less than this while its button is down, pixels, has clicked. */
    static final double CLICK = 3;

    private final Drag drag;
    private final Vec pressed;
    private final ObstacleMover mover;
    private Optional<Pose> wanted = Optional.empty();

    DragInProgress(Drag drag, Vec pressed, ObstacleMover mover) {
        this.drag = drag;
        this.pressed = pressed;
        this.mover = mover;
    }

    String obstacle() {
        return drag.obstacle().id();
    }

    /** The mouse is over a place of the picture and a point of the world. */
    void to(Vec screen, Vec world) {
        if (wanted.isPresent() || screen.distanceTo(pressed) >= CLICK) {
            Pose pose = drag.wanted(world);
            wanted = Optional.of(pose);
            mover.send(obstacle(), pose);
        }
    }

    /** Sends the obstacle back to where it was. */
    void cancel() {
        if (wanted.isPresent()) {
            mover.send(obstacle(), drag.obstacle().pose());
        }
    }

    void paint(Brush brush) {
        wanted.ifPresent(pose -> SelectionPainter.paintWanted(brush, drag.obstacle(), pose, drag.values(pose)));
    }
}
