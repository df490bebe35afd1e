package faultline.gui.canvas;

import faultline.engine.Path;
import faultline.paint.Brush;
import faultline.paint.Camera;
import faultline.paint.PathPainter;
import faultline.paint.PathStyle;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;

/**
 * A path, point by point. Points are added to its picture in batches, because an image that changes must be sent to the screen again as a
 * whole; the few points since the last batch are painted with each frame.
 *
 * @param path so far
 * @param style how it is drawn
 */
record PathMotif(Path path, PathStyle style) implements Motif<PathMotif> {

    /** How many points are left to be painted with each frame before they are added: about four seconds of driving. */
    private static final int BATCH = 256;

    /** How many points a frame has time to draw. */
    private static final double POINTS = 5000;

    /** More points than this are not painted with each frame, whatever is missing. */
    private static final int LONGEST_TAIL = 1024;

    @Override
    public boolean isOpaque() {
        return false;
    }

    @Override
    public int pieces() {
        return path.size();
    }

    @Override
    public int paint(Brush brush, Rectangle clip, int from, Effort effort) {
        PathPainter.Stretch painted = PathPainter.paint(brush, path, style, Math.max(0, from - 1), (int) Math.ceil(POINTS * effort.left()), clip);
        effort.spend(painted.cost() / POINTS);
        return painted.end();
    }

    @Override
    public boolean isShownBy(PathMotif earlier) {
        return path.continues(earlier.path) && path.size() - earlier.path.size() < BATCH;
    }

    @Override
    public Optional<Patch> since(PathMotif earlier, Camera camera) {
        return path.continues(earlier.path) ? Optional.of(new Patch(List.of(camera.bounds()), earlier.path.size())) : Optional.empty();
    }

    /** The index of the first point to be painted with each frame beside the picture of an earlier motif: the last one in that picture. */
    int tailFrom(Optional<PathMotif> shown) {
        int painted = shown.map(PathMotif::path).filter(path::continues).map(Path::size).orElse(path.size());
        return Math.max(painted, path.size() - LONGEST_TAIL) - 1;
    }
}
