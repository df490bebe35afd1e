package faultline.gui.canvas.cache;

import java.awt.Point;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;

/**
 * An image of a layer and its progress.
 *
 * @param content the content that it shows
 * @param buffer the image so far
 * @param parts the parts still to be painted, one after the other, pixels
 * @param next the first piece that is not painted in the first part
 */
record LayerProgress<C extends LayerContent<C>>(C content, LayerBuffer buffer, List<Rectangle> parts, int next) {

    LayerProgress {
        parts = disjoint(parts);
    }

    /** Returns the parts without overlaps, which would show at translucent edges. */
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

    static <C extends LayerContent<C>> LayerProgress<C> blank(C content, LayerBuffer.LayerView view) {
        return new LayerProgress<>(content, LayerBuffer.blank(view, content.isOpaque()), List.of(view.bounds()), 0);
    }

    boolean isDone() {
        return parts.isEmpty();
    }

    boolean shows(C wanted, LayerBuffer.LayerView view) {
        return isDone() && buffer.view().equals(view) && wanted.isSatisfiedBy(content);
    }

    /** Returns this image, painted until it is complete or the budget is spent. */
    LayerProgress<C> advanced(FrameBudget budget) {
        LayerProgress<C> now = this;
        while (!now.isDone() && !budget.isSpent()) {
            now = now.paintNextPart(budget);
        }
        return now;
    }

    private LayerProgress<C> paintNextPart(FrameBudget budget) {
        Rectangle part = parts.get(0);
        int[] reached = {next};
        buffer.paint(part, context -> reached[0] = content.paint(context, part, next, budget));
        boolean done = reached[0] >= content.pieceCount();
        return done
                ? new LayerProgress<>(content, buffer, parts.subList(1, parts.size()), 0)
                : new LayerProgress<>(content, buffer, parts, reached[0]);
    }

    /** Returns this image on its way to another content or view; empty if a new image is cheaper. */
    Optional<LayerProgress<C>> adaptTo(C wanted, LayerBuffer.LayerView view) {
        if (!buffer.view().equals(view)) {
            return buffer.view().offsetTo(view).map(by -> moved(by, view));
        }
        return wanted.isSatisfiedBy(content)
                ? Optional.of(this)
                : wanted.patchSince(content, view.camera()).map(patch -> patched(wanted, patch));
    }

    private LayerProgress<C> moved(Point by, LayerBuffer.LayerView to) {
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

    /** Pieces that are only added wait until the rest is painted. */
    private LayerProgress<C> patched(C newer, LayerContent.Patch patch) {
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

    private LayerProgress<C> cleared() {
        parts.forEach(buffer::clear);
        return this;
    }
}
