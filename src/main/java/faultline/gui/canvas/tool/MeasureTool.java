package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.surface.DrawContext;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Measures from where the button went down to where it is, as often as the user likes; the last measure stays until the
 * tool is put away.
 */
public final class MeasureTool implements Tool {

    private Optional<Vector2> from = Optional.empty();
    private Vector2 to = Vector2.ZERO;
    private boolean done;

    @Override
    public void press(Vector2 at, boolean twice) {
        from = Optional.of(at);
        to = at;
    }

    @Override
    public void move(Vector2 at, boolean down) {
        if (down) {
            to = at;
        }
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

    /** Distance, angle against the x axis in (-180, 180], and both parts of the way; empty before the first press. */
    Optional<String> measurementText() {
        return from.map(start -> {
            Vector2 way = to.minus(start);
            return Messages.get(
                    "value.measure",
                    metres(way.length()),
                    String.format(Locale.ROOT, "%.1f", Math.toDegrees(way.angle())),
                    metres(way.x()),
                    metres(way.y()));
        });
    }

    private static String metres(double length) {
        return String.format(Locale.ROOT, "%.3f", length);
    }

    @Override
    public void paint(DrawContext brush) {
        from.ifPresent(start -> InteractionPainter.paintSketch(brush, List.of(start, to), false));
        measurementText()
                .ifPresent(text -> InteractionPainter.paintValues(
                        brush, text, List.of(), brush.camera().toScreen(to)));
    }
}
