package faultline.gui.canvas;

import faultline.engine.Path;
import faultline.paint.PathPainter;
import java.util.Optional;

/**
 * Keeps the picture of the path and adds to it what the robot has driven since. It adds in batches, because an image that changes must be sent
 * to the screen again as a whole; the few points since the last batch are painted with each frame.
 */
final class PathLayer {

    /** How many points are left to be painted with each frame before they are added: about four seconds of driving. */
    private static final int BATCH = 256;

    private record Kept(Path path, int settled, LayerImage image) {
    }

    private Optional<Kept> kept = Optional.empty();

    /** The picture of the path's beginning, brought up to date, and how many points it holds by {@link #settled()}. */
    LayerImage image(LayerImage.View view, Path path) {
        Kept old = kept.filter(k -> path.continues(k.path()) && k.image().view().equals(view))
                .orElseGet(() -> new Kept(path, 0, LayerImage.transparent(view)));
        boolean due = old.settled() == 0 || path.size() - old.settled() >= BATCH;
        if (due) {
            old.image().paint(brush -> PathPainter.paint(brush, path, Math.max(0, old.settled() - 1), path.size()));
        }
        kept = Optional.of(new Kept(path, due ? path.size() : old.settled(), old.image()));
        return old.image();
    }

    /** How many points of the path the picture holds. */
    int settled() {
        return kept.map(Kept::settled).orElse(0);
    }
}
