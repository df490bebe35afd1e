package faultline.gui.canvas.cache;

import faultline.engine.RobotPath;
import faultline.paint.scene.PathPainter;
import faultline.paint.scene.PathStyle;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;

/**
 * A path, point by point. Points are added to its picture in batches, because an image that changes must be sent to the
 * screen again as a whole; the few points since the last batch are painted with each frame.
 *
 * @param path so far
 * @param style how it is drawn
 */
public record PathLayer(RobotPath path, PathStyle style) implements LayerContent<PathLayer> {

    /** How many points are left to be painted with each frame before they are added: about four seconds of driving. */
    private static final int BATCH_SIZE = 256;

    /** How many points a frame has time to draw. */
    private static final double POINTS_PER_FRAME = 5000;

    /** More points than this are not painted with each frame, whatever is missing. */
    private static final int MAX_TAIL = 1024;

    @Override
    public boolean isOpaque() {
        return false;
    }

    @Override
    public int pieceCount() {
        return path.size();
    }

    @Override
    public int paint(DrawContext brush, Rectangle clip, int from, FrameBudget effort) {
        PathPainter.PaintedSection painted = PathPainter.paint(
                brush,
                path,
                style,
                Math.max(0, from - 1),
                (int) Math.ceil(POINTS_PER_FRAME * effort.remaining()),
                clip);
        effort.spend(painted.cost() / POINTS_PER_FRAME);
        return painted.endIndex();
    }

    @Override
    public boolean isSatisfiedBy(PathLayer earlier) {
        return path.isContinuationOf(earlier.path) && path.size() - earlier.path.size() < BATCH_SIZE;
    }

    @Override
    public Optional<Patch> patchSince(PathLayer earlier, Camera camera) {
        return path.isContinuationOf(earlier.path)
                ? Optional.of(new Patch(List.of(camera.bounds()), earlier.path.size()))
                : Optional.empty();
    }

    /**
     * The index of the first point to be painted with each frame beside the picture of an earlier motif: the last one
     * in that picture.
     */
    public int tailStart(Optional<PathLayer> shown) {
        int painted = shown.map(PathLayer::path)
                .filter(path::isContinuationOf)
                .map(RobotPath::size)
                .orElse(path.size());
        return Math.max(painted, path.size() - MAX_TAIL) - 1;
    }
}
