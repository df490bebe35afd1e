package faultline.gui.canvas;

import faultline.engine.Path;
import faultline.paint.PathPainter;
import java.util.Optional;

/**
 * Keeps the picture of the path and adds to it what the robot has driven since. It adds in batches, because an image that changes
 * must be sent to the screen again as a whole; the few points since the last batch are painted with each frame. After a zoom a very
 * long path is drawn in several goes, so that no frame takes long.
 */
final class PathLayer {

    /** How many points are left to be painted with each frame before they are added: about four seconds of driving. */
    private static final int BATCH = 256;

    /** How many points are added in one go: some 10 ms. */
    private static final int GO = 16_384;

    private record Kept(Path path, int settled, LayerImage image) {
        boolean isComplete() {
            return path.size() - settled < BATCH;
        }
    }

    private Optional<Kept> kept = Optional.empty();

    /** The picture of the path's beginning, brought up to date as far as one go brings it. */
    LayerImage image(LayerImage.View view, Path path) {
        Kept old = kept.filter(k -> path.continues(k.path()) && k.image().view().equals(view))
                .orElseGet(() -> new Kept(path, 0, LayerImage.transparent(view)));
        Kept grown = grown(new Kept(path, old.settled(), old.image()));
        kept = Optional.of(grown);
        return grown.image();
    }

    private static Kept grown(Kept now) {
        if (now.settled() > 0 && now.isComplete()) {
            return now;
        }
        int to = Math.min(now.path().size(), now.settled() + GO);
        now.image().paint(brush -> PathPainter.paint(brush, now.path(), Math.max(0, now.settled() - 1), to));
        return new Kept(now.path(), to, now.image());
    }

    /** Whether all but the last few points are in the picture; if not, it must be asked for again soon. */
    boolean isComplete() {
        return kept.map(Kept::isComplete).orElse(true);
    }

    /** The index of the first point to be painted with each frame: the last one in the picture, or of all while that is far behind. */
    int tailFrom() {
        return kept.map(k -> (k.isComplete() ? k.settled() : k.path().size()) - 1).orElse(0);
    }
}
