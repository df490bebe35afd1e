package faultline.gui.canvas;

import java.awt.Point;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;

/**
 * An image that is kept, and how far it is made.
 *
 * @param motif what it shows
 * @param image the picture so far
 * @param parts what is still to be painted, one after the other, pixels
 * @param next the first piece that is not painted in the first of them
 */
record KeptImage<M extends Motif<M>>(M motif, LayerImage image, List<Rectangle> parts, int next) {

    KeptImage {
        parts = disjoint(parts);
    }

    /** The same without what is there twice, which translucent edges would show. */
    private static List<Rectangle> disjoint(List<Rectangle> parts) {
        List<Rectangle> apart = new ArrayList<>();
        for (Rectangle part : parts) {
            Stream<Rectangle> left = Stream.of(part);
            for (Rectangle other : List.copyOf(apart)) {
                left = left.flatMap(rest -> rest.intersects(other) ? Stream.of(SwingUtilities.computeDifference(rest, other)) : Stream.of(rest));
            }
            left.filter(rest -> !rest.isEmpty()).forEach(apart::add);
        }
        return List.copyOf(apart);
    }

    static <M extends Motif<M>> KeptImage<M> blank(M motif, LayerImage.View view) {
        return new KeptImage<>(motif, LayerImage.blank(view, motif.isOpaque()), List.of(view.bounds()), 0);
    }

    boolean isDone() {
        return parts.isEmpty();
    }

    boolean shows(M wanted, LayerImage.View view) {
        return isDone() && image.view().equals(view) && wanted.isShownBy(motif);
    }

    /** This painted on until all is painted or the effort is spent. */
    KeptImage<M> advanced(Effort effort) {
        KeptImage<M> now = this;
        while (!now.isDone() && !effort.isSpent()) {
            now = now.paintedOn(effort);
        }
        return now;
    }

    private KeptImage<M> paintedOn(Effort effort) {
        Rectangle part = parts.get(0);
        int[] reached = {next};
        image.paint(part, brush -> reached[0] = motif.paint(brush, part, next, effort));
        boolean done = reached[0] >= motif.pieces();
        return done ? new KeptImage<>(motif, image, parts.subList(1, parts.size()), 0) : new KeptImage<>(motif, image, parts, reached[0]);
    }

    /** This on its way to another motif or another view; empty where a new image is cheaper. */
    Optional<KeptImage<M>> towards(M wanted, LayerImage.View view) {
        if (!image.view().equals(view)) {
            return image.view().moveTo(view).map(by -> moved(by, view));
        }
        return wanted.isShownBy(motif) ? Optional.of(this) : wanted.since(motif, view.camera()).map(patch -> patched(wanted, patch));
    }

    private KeptImage<M> moved(Point by, LayerImage.View to) {
        Stream<Rectangle> left = parts.stream().map(part -> {
            Rectangle there = new Rectangle(part);
            there.translate(by.x, by.y);
            return there.intersection(to.bounds());
        });
        return new KeptImage<>(motif, image.moved(by, to), Stream.concat(left, image.exposed(by).stream()).toList(), 0).cleared();
    }

    /** What is only added waits until the rest is done. */
    private KeptImage<M> patched(M newer, Motif.Patch patch) {
        if (patch.from() > 0) {
            return isDone() ? new KeptImage<>(newer, image, patch.parts(), patch.from()) : this;
        }
        return new KeptImage<>(newer, image, Stream.concat(parts.stream(), patch.parts().stream()).toList(), 0).cleared();
    }

    private KeptImage<M> cleared() {
        parts.forEach(image::clear);
        return this;
    }
}
