package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.text.Texts;
import faultline.paint.Brush;
import faultline.paint.HandPainter;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Measures from where the button went down to where it is, as often as the user likes; the last measure stays until the tool is put away.
 */
final class MeasureTool implements Tool {

    private Optional<Vec> from = Optional.empty();
    private Vec to = Vec.ZERO;
    private boolean done;

    @Override
    public void press(Vec at, boolean twice) {
        from = Optional.of(at);
        to = at;
    }

    @Override
    public void move(Vec at, boolean down) {
        if (down) {
            to = at;
        }
    }

    @Override
    public void release(Vec at) {
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
    Optional<String> measure() {
        return from.map(start -> {
            Vec way = to.minus(start);
            return Texts.text("value.measure", metres(way.length()), String.format(Locale.ROOT, "%.1f", Math.toDegrees(way.angle())),
                    metres(way.x()), metres(way.y()));
        });
    }

    private static String metres(double length) {
        return String.format(Locale.ROOT, "%.3f", length);
    }

    @Override
    public void paint(Brush brush) {
        from.ifPresent(start -> HandPainter.paintSketch(brush, List.of(start, to), false));
        measure().ifPresent(text -> HandPainter.paintValues(brush, text, List.of(), brush.camera().toScreen(to)));
    }
}
