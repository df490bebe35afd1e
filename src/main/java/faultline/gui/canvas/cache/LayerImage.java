package faultline.gui.canvas.cache;

import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import java.awt.AlphaComposite;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;

/**
 * An image of a layer at the resolution of the device, as sharp as if it were painted directly, and its progress.
 *
 * @param content the content that it shows
 * @param view the view that it is painted for
 * @param image the image so far; its pixels are device pixels
 * @param parts the parts still to be painted, one after the other, pixels
 * @param next the first piece that is not painted in the first part
 */
record LayerImage<C extends LayerContent<C>>(
        C content, LayerRenderSettings view, BufferedImage image, List<Rectangle> parts, int next) {

    LayerImage {
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

    /** Returns an image of which nothing is painted; an opaque one is drawn faster. */
    static <C extends LayerContent<C>> LayerImage<C> blank(C content, LayerRenderSettings view) {
        int width = (int) Math.ceil(view.camera().width() * view.deviceScale());
        int height = (int) Math.ceil(view.camera().height() * view.deviceScale());
        int type = content.isOpaque() ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB_PRE;
        List<Rectangle> bands = bands(view.bounds(), content.bandCount());
        return new LayerImage<>(content, view, new BufferedImage(width, height, type), bands, 0);
    }

    /** Divides an area into bands from top to bottom; some are empty if there are more bands than pixels. */
    private static List<Rectangle> bands(Rectangle area, int count) {
        return IntStream.range(0, count)
                .mapToObj(band -> {
                    int top = area.height * band / count;
                    int bottom = area.height * (band + 1) / count;
                    return new Rectangle(area.x, area.y + top, area.width, bottom - top);
                })
                .toList();
    }

    boolean isDone() {
        return parts.isEmpty();
    }

    boolean isCurrent(C wanted, LayerRenderSettings wantedView) {
        return isDone() && view.equals(wantedView) && wanted.isSatisfiedBy(content);
    }

    /** Returns this image, painted until it is complete or the budget is spent. */
    LayerImage<C> advanced(FrameBudget budget) {
        LayerImage<C> now = this;
        while (!now.isDone() && !budget.isSpent()) {
            now = now.paintNextPart(budget);
        }
        return now;
    }

    private LayerImage<C> paintNextPart(FrameBudget budget) {
        Rectangle part = parts.get(0);
        Graphics2D graphics = graphics();
        graphics.setClip(part);
        int reached = content.paint(new DrawContext(graphics, view.camera(), view.palette()), part, next, budget);
        graphics.dispose();
        return reached >= content.pieceCount()
                ? new LayerImage<>(content, view, image, parts.subList(1, parts.size()), 0)
                : new LayerImage<>(content, view, image, parts, reached);
    }

    private Graphics2D graphics() {
        Graphics2D graphics = image.createGraphics();
        graphics.scale(view.deviceScale(), view.deviceScale());
        return graphics;
    }

    /** Returns this image in transition to another content or view; empty if a new image is cheaper. */
    Optional<LayerImage<C>> adaptTo(C wanted, LayerRenderSettings wantedView) {
        if (!view.equals(wantedView)) {
            return view.offsetTo(wantedView).map(by -> moved(by, wantedView));
        }
        return wanted.isSatisfiedBy(content)
                ? Optional.of(this)
                : wanted.patchSince(content, view.camera()).map(patch -> patched(wanted, patch));
    }

    /** Returns this image with its pixels moved; what comes into view is still to be painted. */
    private LayerImage<C> moved(Point by, LayerRenderSettings to) {
        Graphics2D graphics = image.createGraphics();
        graphics.setComposite(AlphaComposite.Src);
        graphics.copyArea(0, 0, image.getWidth(), image.getHeight(), (int) (by.x * view.deviceScale()), (int)
                (by.y * view.deviceScale()));
        graphics.dispose();
        Stream<Rectangle> left = parts.stream().map(part -> {
            Rectangle there = new Rectangle(part);
            there.translate(by.x, by.y);
            return there.intersection(to.bounds());
        });
        return new LayerImage<>(
                        content,
                        to,
                        image,
                        Stream.concat(left, exposedParts(by)).toList(),
                        0)
                .cleared();
    }

    /** Returns the parts that come into view when the content moves; they may be empty. */
    private Stream<Rectangle> exposedParts(Point by) {
        int width = view.camera().width();
        int height = view.camera().height();
        return Stream.of(
                new Rectangle(by.x > 0 ? 0 : width + by.x, 0, Math.abs(by.x), height),
                new Rectangle(0, by.y > 0 ? 0 : height + by.y, width, Math.abs(by.y)));
    }

    /** Pieces that are only added wait until the rest is painted. */
    private LayerImage<C> patched(C newer, LayerContent.Patch patch) {
        if (patch.from() > 0) {
            return isDone() ? new LayerImage<>(newer, view, image, patch.parts(), patch.from()) : this;
        }
        Stream<Rectangle> all = Stream.concat(parts.stream(), patch.parts().stream());
        return new LayerImage<>(newer, view, image, all.toList(), 0).cleared();
    }

    /** Makes the parts still to be painted transparent, unless the image is opaque. */
    private LayerImage<C> cleared() {
        if (!content.isOpaque()) {
            Graphics2D graphics = graphics();
            graphics.setComposite(AlphaComposite.Clear);
            parts.forEach(graphics::fill);
            graphics.dispose();
        }
        return this;
    }

    /** Draws the image: pixel by pixel in its own view, scaled in another. */
    void draw(Graphics2D graphics, Camera now) {
        Camera then = view.camera();
        AffineTransform place = new AffineTransform();
        if (!then.equals(now)) {
            double stretch = now.scale() / then.scale();
            place.translate(
                    now.width() / 2.0 + now.scale() * (then.x() - now.x()) - stretch * then.width() / 2,
                    now.height() / 2.0 - now.scale() * (then.y() - now.y()) - stretch * then.height() / 2);
            place.scale(stretch, stretch);
        }
        place.scale(1 / view.deviceScale(), 1 / view.deviceScale());
        Image pixels = image;
        graphics.drawImage(pixels, place, null);
    }
}
