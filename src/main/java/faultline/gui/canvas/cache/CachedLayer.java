package faultline.gui.canvas.cache;

import faultline.paint.surface.Camera;
import java.awt.Graphics2D;
import java.util.Optional;

/**
 * Caches a layer of the canvas as an image, and updates it over several frames, so that no frame takes long. If the
 * content has moved, or changed in a few places, the image is shifted and patched; otherwise a new image is painted
 * behind the old one, which is drawn until then, scaled to the new view.
 *
 * @param <C> the content
 */
public final class CachedLayer<C extends LayerContent<C>> {

    /** Drawn; null before the first update. */
    private LayerImage<C> front;
    /** Painted behind the front image; null if the front image itself is updated. */
    private LayerImage<C> back;

    private boolean complete;

    /** Updates the image for as long as the budget of the frame allows. */
    public void update(C content, LayerRenderSettings view, FrameBudget budget) {
        if (back == null) {
            prepare(content, view);
        }
        if (back == null) {
            front = front.advanced(budget);
        } else {
            back = back.advanced(budget);
            if (back.isDone()) {
                front = back;
                back = null;
            }
        }
        complete = back == null && front.isCurrent(content, view);
    }

    /** Starts an update. A started image is completed first, or a view that keeps changing would never show. */
    private void prepare(C content, LayerRenderSettings view) {
        if (front == null) {
            front = LayerImage.blank(content, view);
        } else if (!front.isCurrent(content, view)) {
            front.adaptTo(content, view)
                    .ifPresentOrElse(adapted -> front = adapted, () -> back = LayerImage.blank(content, view));
        }
    }

    /** Discards the images. */
    public void clear() {
        front = null;
        back = null;
    }

    /** Returns whether the image shows the last content; if not, the update must be repeated soon. */
    public boolean isComplete() {
        return complete;
    }

    /** Returns the content of the image that is drawn; empty if there is none. */
    public Optional<C> shownContent() {
        return Optional.ofNullable(front).map(LayerImage::content);
    }

    /** Draws the image, scaled to the camera. */
    public void draw(Graphics2D graphics, Camera camera) {
        if (front != null) {
            front.draw(graphics, camera);
        }
    }
}
