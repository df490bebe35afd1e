package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.text.AngleText;
import faultline.gui.text.Messages;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.surface.DrawContext;
import java.util.List;
import java.util.Optional;

/**
 * Measures from where the button is pressed to where it is released, repeatedly; the last measurement stays until the
 * tool is deactivated.
 */
public final class MeasureTool implements Tool {

    /** Null before the first press. */
    private Vector2 from;

    private Vector2 to = Vector2.ZERO;
    private boolean done;

    @Override
    public void press(Vector2 at, boolean twice) {
        from = at;
        to = at;
    }

    @Override
    public void move(Vector2 at, boolean down) {
        if (down) {
            to = at;
        }
    }

    @Override
    public void moveByKey(Vector2 at) {
        to = at;
    }

    @Override
    public void release(Vector2 at) {
        to = at;
    }

    @Override
    public void finish() {
        done = true;
    }

    @Override
    public boolean isDone() {
        return done;
    }

    /**
     * Returns the distance, the angle to the x axis in (-180, 180] and both components; empty before the first press.
     */
    Optional<String> measurementText() {
        return Optional.ofNullable(from).map(start -> {
            Vector2 offset = to.minus(start);
            return Messages.get(
                    "value.measure",
                    ShapeHandles.formatMetres(offset.length()),
                    AngleText.degrees(offset.angle(), 1),
                    ShapeHandles.formatMetres(offset.x()),
                    ShapeHandles.formatMetres(offset.y()));
        });
    }

    @Override
    public void paint(DrawContext context) {
        if (from != null) {
            InteractionPainter.paintSketch(context, List.of(from, to), false);
        }
        measurementText()
                .ifPresent(text -> InteractionPainter.paintValues(
                        context, text, List.of(), context.camera().toScreen(to)));
    }
}
