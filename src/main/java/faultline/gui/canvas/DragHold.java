package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.edit.Snap;
import faultline.gui.text.Texts;
import faultline.paint.Brush;
import faultline.paint.HandPainter;
import faultline.world.Obstacle;
import java.util.List;
import java.util.Optional;

/** One drag from the press of the button on: nothing happens before the mouse has moved far enough to mean it. */
final class DragHold implements Hold {

    private final Drag drag;
    private final Vec pressed;
    private final Scene scene;
    private final Viewpoint viewpoint;
    private final Courier courier;
    private Optional<Wish> wish = Optional.empty();
    private Vec last;

    DragHold(Drag drag, Vec pressed, Scene scene, Viewpoint viewpoint, Courier courier) {
        this.drag = drag;
        this.pressed = pressed;
        this.scene = scene;
        this.viewpoint = viewpoint;
        this.courier = courier;
        this.last = pressed;
        courier.begin();
    }

    @Override
    public void to(Vec screen, Snap snap) {
        last = screen;
        if (wish.isPresent() || screen.distanceTo(pressed) >= CLICK) {
            want(drag.wanted(viewpoint.camera().get().toWorld(screen), snap));
        }
    }

    private void want(Wish wanted) {
        boolean isNew = wish.filter(before -> before.commands().equals(wanted.commands())).isEmpty();
        wish = Optional.of(wanted);
        if (isNew) {
            courier.send(wanted.commands());
        }
    }

    @Override
    public void release() {
        courier.end();
    }

    @Override
    public void cancel() {
        if (wish.isPresent()) {
            courier.send(drag.back());
        }
        courier.end();
    }

    @Override
    public boolean isLost() {
        return !scene.ids().containsAll(drag.obstacles().stream().map(Obstacle::id).toList());
    }

    @Override
    public void paint(Brush brush) {
        wish.ifPresent(wanted -> {
            List<Obstacle> blocked = wanted.there().stream().filter(obstacle -> Room.isBlocked(scene, obstacle)).toList();
            paint(brush, wanted.there(), blocked);
            if (blocked.isEmpty()) {
                HandPainter.paintValues(brush, wanted.values(), wanted.there(), last);
            } else {
                HandPainter.paintRefusal(brush, Texts.text("refused.robot", blocked.get(0).id()), wanted.there(), last);
            }
        });
    }

    private static void paint(Brush brush, List<Obstacle> there, List<Obstacle> blocked) {
        if (there.size() <= Picture.FEW) {
            there.forEach(obstacle -> HandPainter.paintWanted(brush, obstacle, blocked.contains(obstacle)));
        } else {
            HandPainter.paintWanted(brush, there, !blocked.isEmpty());
        }
    }
}
