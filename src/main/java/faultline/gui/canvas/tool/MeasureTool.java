package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.text.AngleText;
import faultline.gui.text.Messages;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.scene.ObstacleGroup;
import faultline.paint.surface.DrawContext;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;

/**
 * Measures from where the button is pressed to where it is released, or from one click to the next, repeatedly; the
 * last measurement stays until the tool is deactivated.
 */
public final class MeasureTool implements Tool {

    private final DoubleSupplier clickTolerance;
    /** Null before the first press. */
    private Vector2 from;

    private Vector2 to = Vector2.ZERO;
    /** Whether a press has started the measurement that the release ends. */
    private boolean started;
    /** Whether a click has started a measurement, whose end follows the mouse until the next press. */
    private boolean following;

    private boolean done;

    /** Creates a tool, given what returns the distance in metres up to which a press and a release are a click. */
    MeasureTool(DoubleSupplier clickTolerance) {
        this.clickTolerance = clickTolerance;
    }

    @Override
    public void press(Vector2 at, boolean twice) {
        started = !following;
        following = false;
        from = started ? at : from;
        to = at;
    }

    @Override
    public void move(Vector2 at, boolean down) {
        if (down || following) {
            to = at;
        }
    }

    @Override
    public void moveByKey(Vector2 at) {
        to = at;
        following = false;
    }

    @Override
    public void release(Vector2 at) {
        to = at;
        following = started && from.distanceTo(at) < clickTolerance.getAsDouble();
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
                        context, text, ObstacleGroup.NONE, context.camera().toScreen(to)));
    }
}
