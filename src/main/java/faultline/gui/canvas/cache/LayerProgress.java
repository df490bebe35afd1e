package faultline.gui.canvas.cache;

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
 * @param content what it shows
 * @param buffer the picture so far
 * @param parts what is still to be painted, one after the other, pixels
 * @param next the first piece that is not painted in the first of them
 */
record LayerProgress<M extends LayerContent<M>>(M content, LayerBuffer buffer, List<Rectangle> parts, int next) {

    LayerProgress {
        parts = disjoint(parts);
    }

    /** The same without what is there twice, which translucent edges would show. */
    private static List<Rectangle> disjoint(List<Rectangle> parts) {
        List<Rectangle> apart = new ArrayList<>();
        for (Rectangle part : parts) {
            Stream<Rectangle> left = Stream.of(part);
            for (Rectangle other : List.copyOf(apart)) {
                left = left.flatMap(rest -> rest.intersects(other)
                        ? Stream.of(SwingUtilities.computeDifference(rest, other))
                        : Stream.of(rest));
            }
            left.filter(rest -> !rest.isEmpty()).forEach(apart::add);
        }
        return List.copyOf(apart);
    }

    static <M extends LayerContent<M>> LayerProgress<M> blank(M motif, LayerBuffer.View view) {
        return new LayerProgress<>(motif, LayerBuffer.blank(view, motif.isOpaque()), List.of(view.bounds()), 0);
    }

    boolean isDone() {
        return parts.isEmpty();
    }

    boolean shows(M wanted, LayerBuffer.View view) {
        return isDone() && buffer.view().equals(view) && wanted.isSatisfiedBy(content);
    }

    /** This painted on until all is painted or the effort is spent. */
    LayerProgress<M> advanced(FrameBudget effort) {
        LayerProgress<M> now = this;
        while (!now.isDone() && !effort.isSpent()) {
            now = now.paintNextPart(effort);
        }
        return now;
    }

    private LayerProgress<M> paintNextPart(FrameBudget effort) {
        Rectangle part = parts.get(0);
        int[] reached = {next};
        buffer.paint(part, brush -> reached[0] = content.paint(brush, part, next, effort));
        boolean done = reached[0] >= content.pieceCount();
        return done
                ? new LayerProgress<>(content, buffer, parts.subList(1, parts.size()), 0)
                : new LayerProgress<>(content, buffer, parts, reached[0]);
    }

    /** This on its way to another motif or another view; empty where a new image is cheaper. */
    Optional<LayerProgress<M>> adaptTo(M wanted, LayerBuffer.View view) {
        if (!buffer.view().equals(view)) {
            return buffer.view().offsetTo(view).map(by -> moved(by, view));
        }
        return wanted.isSatisfiedBy(content)
                ? Optional.of(this)
                : wanted.patchSince(content, view.camera()).map(patch -> patched(wanted, patch));
    }

    private LayerProgress<M> moved(Point by, LayerBuffer.View to) {
        Stream<Rectangle> left = parts.stream().map(part -> {
            Rectangle there = new Rectangle(part);
            there.translate(by.x, by.y);
            return there.intersection(to.bounds());
        });
        return new LayerProgress<>(
                        content,
                        buffer.moved(by, to),
                        Stream.concat(left, buffer.exposedParts(by).stream()).toList(),
                        0)
                .cleared();
    }

    /** What is only added waits until the rest is done. */
    private LayerProgress<M> patched(M newer, LayerContent.Patch patch) {
        if (patch.from() > 0) {
            return isDone() ? new LayerProgress<>(newer, buffer, patch.parts(), patch.from()) : this;
        }
        return new LayerProgress<>(
                        newer,
                        buffer,
                        Stream.concat(parts.stream(), patch.parts().stream()).toList(),
                        0)
                .cleared();
    }

    private LayerProgress<M> cleared() {
        parts.forEach(buffer::clear);
        return this;
    }
}
