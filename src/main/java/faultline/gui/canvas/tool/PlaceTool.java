package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.IdGenerator;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.edit.ShapePreset;
import faultline.gui.text.Messages;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.surface.DrawContext;
import faultline.world.Obstacle;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Places a shape by a click, or by a drag from corner to corner. */
public final class PlaceTool implements Tool {

    private final ShapePreset shape;
    private final ToolContext context;
    private Optional<Vector2> pressed = Optional.empty();
    private Optional<Obstacle> preview = Optional.empty();
    private boolean done;

    public PlaceTool(ShapePreset shape, ToolContext context) {
        this.shape = shape;
        this.context = context;
    }

    private String newId() {
        return IdGenerator.uniqueId(
                shape.name().toLowerCase(Locale.ROOT), context.model().obstacleIds());
    }

    @Override
    public void press(Vector2 at, boolean twice) {
        pressed = Optional.of(at);
        move(at, true);
    }

    @Override
    public void move(Vector2 at, boolean down) {
        boolean drawn =
                pressed.filter(from -> context.isBeyondClickTolerance(from, at)).isPresent();
        preview = Optional.of(
                drawn
                        ? shape.createBetween(newId(), pressed.orElseThrow(), at)
                        : shape.createAt(newId(), pressed.orElse(at)));
    }

    @Override
    public void release(Vector2 at) {
        move(at, true);
        done = preview.filter(context::placeObstacle).isPresent();
        pressed = Optional.empty();
    }

    @Override
    public void confirm(Vector2 at) {
        pressed = Optional.empty();
        release(at);
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
    public void paint(DrawContext brush) {
        preview.ifPresent(obstacle -> {
            boolean blocked = PlacementCheck.overlapsRobot(context.model(), obstacle);
            InteractionPainter.paintPreview(brush, obstacle, blocked);
            if (blocked) {
                InteractionPainter.paintRefusal(
                        brush, Messages.get("refused.robot", obstacle.id()), List.of(obstacle), Vector2.ZERO);
            } else if (pressed.isPresent()) {
                InteractionPainter.paintValues(
                        brush, ShapeHandles.sizeText(obstacle, 0), List.of(obstacle), Vector2.ZERO);
            }
        });
    }
}
