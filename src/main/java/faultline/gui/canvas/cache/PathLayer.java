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
 * A path, point by point. Points are added to its image in batches, because a changed image must be sent to the screen
 * as a whole; the few points since the last batch are painted with each frame.
 */
public record PathLayer(RobotPath path, PathStyle style) implements LayerContent<PathLayer> {

    /** The number of points that are painted with each frame before they are added: about four seconds of driving. */
    private static final int BATCH_SIZE = 256;

    /** The number of points that a frame has time for. */
    private static final double POINTS_PER_FRAME = 5000;

    /** The largest number of points that are painted with each frame, even if more are missing. */
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
    public int paint(DrawContext context, Rectangle clip, int from, FrameBudget budget) {
        PathPainter.PaintedSection painted = PathPainter.paint(
                context,
                path,
                style,
                Math.max(0, from - 1),
                (int) Math.ceil(POINTS_PER_FRAME * budget.remaining()),
                clip);
        budget.spend(painted.cost() / POINTS_PER_FRAME);
        return painted.endIndex();
    }

    @Override
    public boolean isSatisfiedBy(PathLayer earlier) {
        return style == earlier.style
                && path.isContinuationOf(earlier.path)
                && path.size() - earlier.path.size() < BATCH_SIZE;
    }

    @Override
    public Optional<Patch> patchSince(PathLayer earlier, Camera camera) {
        return style == earlier.style && path.isContinuationOf(earlier.path)
                ? Optional.of(new Patch(List.of(camera.bounds()), earlier.path.size()))
                : Optional.empty();
    }

    /**
     * Returns the index of the first point to be painted with each frame: the last one of the layer in the image, which
     * is null for none.
     */
    public int tailStart(PathLayer shown) {
        int painted = shown != null && path.isContinuationOf(shown.path) ? shown.path.size() : path.size();
        return Math.max(painted, path.size() - MAX_TAIL) - 1;
    }
}
