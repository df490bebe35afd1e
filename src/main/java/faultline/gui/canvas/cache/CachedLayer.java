package faultline.gui.canvas.cache;

import faultline.paint.surface.Camera;
import java.awt.Graphics2D;
import java.util.Optional;

/**
 * Keeps a part of the picture as an image, and brings it up to date a little with each frame, so that no frame takes
 * long. Where the content has only moved, or changed here and there, the image is moved and mended; else a new one is
 * made behind the old one, which shows until then, stretched to the new view.
 *
 * @param <M> what it shows
 */
public final class CachedLayer<M extends LayerContent<M>> {

    private Optional<LayerProgress<M>> front = Optional.empty();
    private Optional<LayerProgress<M>> back = Optional.empty();
    private boolean complete;

    /** Comes nearer to what is wanted, by as much as a frame has time for. */
    public void update(M motif, LayerBuffer.View view, FrameBudget effort) {
        if (back.isEmpty()) {
            prepare(motif, view);
        }
        if (back.isPresent()) {
            back = back.map(kept -> kept.advanced(effort));
        } else {
            front = front.map(kept -> kept.advanced(effort));
        }
        if (back.filter(LayerProgress::isDone).isPresent()) {
            front = back;
            back = Optional.empty();
        }
        complete =
                back.isEmpty() && front.filter(kept -> kept.shows(motif, view)).isPresent();
    }

    /** An image that is begun is finished before the next is, or a view that goes on changing would never show. */
    private void prepare(M motif, LayerBuffer.View view) {
        if (front.isEmpty()) {
            front = Optional.of(LayerProgress.blank(motif, view));
        } else if (!front.get().shows(motif, view)) {
            Optional<LayerProgress<M>> mended = front.get().adaptTo(motif, view);
            front = mended.or(() -> front);
            back = mended.isPresent() ? Optional.empty() : Optional.of(LayerProgress.blank(motif, view));
        }
    }

    /** Keeps nothing of what was shown. */
    public void clear() {
        front = Optional.empty();
        back = Optional.empty();
    }

    /** Whether all that was wanted last is there; if not, it must be brought again soon. */
    public boolean isComplete() {
        return complete;
    }

    /** What the image that shows was made of. */
    public Optional<M> shownContent() {
        return front.map(LayerProgress::content);
    }

    public void draw(Graphics2D graphics, Camera now) {
        front.ifPresent(kept -> kept.buffer().draw(graphics, now));
    }
}
