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

    /**
     * Paints pieces until the budget is spent; those outside the clip cost next to nothing.
     *
     * @param context the drawing context
     * @param clip the clip of the context, pixels
     * @param from the index of the first piece
     * @param budget the budget of the frame, not spent
     * @return the index of the first piece that was not painted
     */
    int paint(DrawContext context, Rectangle clip, int from, FrameBudget budget);

    /** Returns whether an image of an earlier content also shows this one. */
    boolean isSatisfiedBy(C earlier);

    /** Returns what turns an image of an earlier content into one of this; empty if a new image is cheaper. */
    Optional<Patch> patchSince(C earlier, Camera camera);

    /**
     * An update of an image.
     *
     * @param parts the parts to paint, pixels; they may overlap
     * @param from the first piece that the image lacks; 0 to clear the parts and paint all pieces
     */
    record Patch(List<Rectangle> parts, int from) {}
}
