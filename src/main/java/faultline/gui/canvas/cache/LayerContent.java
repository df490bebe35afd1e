package faultline.gui.canvas.cache;

import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;

/**
 * The content of a layer at one moment: pieces, painted in order. Immutable.
 *
 * @param <C> the kind of content
 */
interface LayerContent<C extends LayerContent<C>> {

    /** Returns whether the first piece covers everything. */
    boolean isOpaque();

    /** Returns the number of pieces. */
    int pieceCount();

    /** Returns the number of bands that a new image is painted in, because a piece may take longer than a frame has. */
    default int bandCount() {
        return 1;
    }

    /**
     * Paints pieces from an index on until the budget is spent, and returns the index of the first that was not
     * painted. Pieces outside the clip, pixels, cost next to nothing.
     */
    int paint(DrawContext context, Rectangle clip, int from, FrameBudget budget);

    /** Returns whether an image of an earlier content also shows this one. */
    boolean isSatisfiedBy(C earlier);

    /** Returns what turns an image of an earlier content into one of this; empty if a new image is cheaper. */
    Optional<Patch> patchSince(C earlier, Camera camera);

    /**
     * The parts of an image to paint, pixels, which may overlap, and the first piece that it lacks; 0 to clear the
     * parts and paint all pieces.
     */
    record Patch(List<Rectangle> parts, int from) {}
}
