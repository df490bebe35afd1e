package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.edit.FreshIds;
import faultline.gui.edit.ReadyShape;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.text.Texts;
import faultline.paint.Brush;
import faultline.paint.HandPainter;
import faultline.world.Obstacle;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Puts a ready shape where the user clicks, or from corner to corner of a drag. */
final class PlaceTool implements Tool {

    private final ReadyShape shape;
    private final Desk desk;
    private Optional<Vec> pressed = Optional.empty();
    private Optional<Obstacle> planned = Optional.empty();
    private boolean done;

    PlaceTool(ReadyShape shape, Desk desk) {
        this.shape = shape;
        this.desk = desk;
    }

    private String id() {
        return FreshIds.like(shape.name().toLowerCase(Locale.ROOT), desk.scene().ids());
    }

    @Override
    public void press(Vec at, boolean twice) {
        pressed = Optional.of(at);
        move(at, true);
    }

    @Override
    public void move(Vec at, boolean down) {
        boolean drawn = pressed.filter(from -> desk.isFar(from, at)).isPresent();
        planned = Optional.of(drawn ? shape.between(id(), pressed.orElseThrow(), at) : shape.at(id(), pressed.orElse(at)));
    }

    @Override
    public void release(Vec at) {
        move(at, true);
        done = planned.filter(desk::put).isPresent();
        pressed = Optional.empty();
    }

    @Override
    public void finish() {
        done = true;
    }

    @Override
    public boolean isDone() {
        return done;
    }

    @Override
    public void paint(Brush brush) {
        planned.ifPresent(obstacle -> {
            boolean blocked = Room.isBlocked(desk.scene(), obstacle);
            HandPainter.paintWanted(brush, obstacle, blocked);
            if (blocked) {
                HandPainter.paintRefusal(brush, Texts.text("refused.robot", obstacle.id()), List.of(obstacle), Vec.ZERO);
            } else if (pressed.isPresent()) {
                HandPainter.paintValues(brush, ShapeHandles.values(obstacle, 0), List.of(obstacle), Vec.ZERO);
            }
        });
    }
}
