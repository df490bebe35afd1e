package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.edit.ShapePreset;
import faultline.gui.text.Messages;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.scene.ObstacleGroup;
import faultline.paint.surface.DrawContext;
import faultline.world.Obstacle;
import java.util.List;

/** Places a shape by a click, or by a drag from corner to corner. */
public final class PlaceTool implements Tool {

    private final ShapePreset shape;
    private final ToolContext context;
    /** Null while the button is up. */
    private Vector2 pressed;

    private Obstacle preview;
    private boolean done;

    public PlaceTool(ShapePreset shape, ToolContext context) {
        this.shape = shape;
        this.context = context;
    }

    /** Returns the id of the preview, which is not computed again with every move of the mouse. */
    private String previewId() {
        return preview == null ? newId() : preview.id();
    }

    private String newId() {
        return context.model().newId(shape.id());
    }

    @Override
    public void press(Vector2 at, boolean twice) {
        pressed = at;
        move(at, true);
    }

    @Override
    public void move(Vector2 at, boolean down) {
        boolean drawn = pressed != null && context.isBeyondClickTolerance(pressed, at);
        preview = drawn
                ? shape.createBetween(previewId(), pressed, at)
                : shape.createAt(previewId(), pressed == null ? at : pressed);
    }

    @Override
    public void release(Vector2 at) {
        move(at, true);
        done = context.placeObstacle(preview.withId(newId()));
        pressed = null;
    }

    @Override
    public void confirm(Vector2 at) {
        pressed = null;
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
    public void paint(DrawContext drawContext) {
        if (preview == null) {
            return;
        }
        boolean blocked = PlacementCheck.overlapsRobot(context.model(), preview);
        InteractionPainter.paintPreview(drawContext, preview, blocked);
        if (blocked) {
            InteractionPainter.paintRefusal(
                    drawContext,
                    Messages.get("refused.robot", preview.id()),
                    ObstacleGroup.of(List.of(preview)),
                    Vector2.ZERO);
        } else if (pressed != null) {
            InteractionPainter.paintValues(
                    drawContext, ShapeHandles.sizeText(preview, 0), ObstacleGroup.of(List.of(preview)), Vector2.ZERO);
        }
    }
}
