package faultline.gui.canvas.cache;

import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;

/**
 * What a kept part of the picture shows at one moment: pieces, painted in their order. Immutable.
 *
 * @param <M> the kind of motif
 */
interface LayerContent<M extends LayerContent<M>> {

    /** Whether the first piece covers all. */
    boolean isOpaque();

    /** How many pieces there are. */
    int pieceCount();

    /**
     * Paints pieces, but no more than a frame has time for; those that do not touch the clip cost next to nothing.
     *
     * @param brush where to
     * @param clip to which the brush is clipped, pixels
     * @param from the first piece
     * @param effort which is not spent yet
     * @return the first piece that was not painted
     */
    int paint(DrawContext brush, Rectangle clip, int from, FrameBudget effort);

    /** Whether a picture of an earlier motif will do for this one. */
    boolean isSatisfiedBy(M earlier);

    /**
     * What turns a picture of an earlier motif into one of this; empty where a new picture is cheaper or nothing can be
     * told.
     */
    Optional<Patch> patchSince(M earlier, Camera camera);

    /**
     * How a picture is brought up to date.
     *
     * @param parts what must be painted anew, pixels; they may overlap
     * @param from the first piece that is not in the picture; 0 to clear the parts and paint all of them
     */
    record Patch(List<Rectangle> parts, int from) {}
}
