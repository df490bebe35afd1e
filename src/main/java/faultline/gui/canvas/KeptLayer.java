package faultline.gui.canvas;

import faultline.paint.Camera;
import java.awt.Graphics2D;
import java.util.Optional;

/**
 * Keeps a part of the picture as an image, and brings it up to date a little with each frame, so that no frame takes long. Where the
 * content has only moved, or changed here and there, the image is moved and mended; else a new one is made behind the old one, which shows
 * until then, stretched to the new view.
 *
 * @param <M> what it shows
 */
final class KeptLayer<M extends Motif<M>> {

    private Optional<KeptImage<M>> front = Optional.empty();
    private Optional<KeptImage<M>> back = Optional.empty();
    private boolean complete;

    /** Comes nearer to what is wanted, by as much as a frame has time for. */
    void bring(M motif, LayerImage.View view, Effort effort) {
        if (back.isEmpty()) {
            turnTo(motif, view);
        }
        if (back.isPresent()) {
            back = back.map(kept -> kept.advanced(effort));
        } else {
            front = front.map(kept -> kept.advanced(effort));
        }
        if (back.filter(KeptImage::isDone).isPresent()) {
            front = back;
            back = Optional.empty();
        }
        complete = back.isEmpty() && front.filter(kept -> kept.shows(motif, view)).isPresent();
    }

    /** An image that is begun is finished before the next is, or a view that goes on changing would never show. */
    private void turnTo(M motif, LayerImage.View view) {
        if (front.isEmpty()) {
            front = Optional.of(KeptImage.blank(motif, view));
        } else if (!front.get().shows(motif, view)) {
            Optional<KeptImage<M>> mended = front.get().towards(motif, view);
            front = mended.or(() -> front);
            back = mended.isPresent() ? Optional.empty() : Optional.of(KeptImage.blank(motif, view));
        }
    }

    /** Keeps nothing of what was shown. */
    void clear() {
        front = Optional.empty();
        back = Optional.empty();
    }

    /** Whether all that was wanted last is there; if not, it must be brought again soon. */
    boolean isComplete() {
        return complete;
    }

    /** What the image that shows was made of. */
    Optional<M> shown() {
        return front.map(KeptImage::motif);
    }

    void show(Graphics2D graphics, Camera now) {
        front.ifPresent(kept -> kept.image().show(graphics, now));
    }
}
