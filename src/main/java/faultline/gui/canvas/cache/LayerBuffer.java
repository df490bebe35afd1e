package faultline.gui.canvas.cache;

import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import java.awt.AlphaComposite;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * An image of a layer at the resolution of the device, as sharp as if it were painted directly.
 *
 * @param image the image; its pixels are device pixels
 * @param view the view that it was painted for
 */
public record LayerBuffer(BufferedImage image, LayerView view) {

    /**
     * Everything but the content that an image depends on.
     *
     * @param camera the mapping from the world to the canvas
     * @param palette the colours
     * @param deviceScale device pixels per pixel
     */
    public record LayerView(Camera camera, Palette palette, double deviceScale) {

        /** An offset that differs by less from whole pixels is an offset by whole pixels. */
        private static final double ROUNDING = 1e-6;

        Rectangle bounds() {
            return camera.bounds();
        }

        /** Returns the offset, pixels, that shows the content in another view; empty if an offset is not enough. */
        Optional<Point> offsetTo(LayerView other) {
            Camera to = other.camera;
            double dx = (camera.x() - to.x()) * camera.scale();
            double dy = (to.y() - camera.y()) * camera.scale();
            boolean whole = Math.abs(dx - Math.rint(dx)) < ROUNDING
                    && Math.abs(dy - Math.rint(dy)) < ROUNDING
                    && deviceScale == Math.rint(deviceScale);
            boolean near = Math.abs(dx) < camera.width() && Math.abs(dy) < camera.height();
            boolean alike = camera.scale() == to.scale()
                    && bounds().equals(other.bounds())
                    && deviceScale == other.deviceScale
                    && palette.equals(other.palette);
            return alike && near && whole
                    ? Optional.of(new Point((int) Math.rint(dx), (int) Math.rint(dy)))
                    : Optional.empty();
        }
    }

    /** Returns an empty image; an opaque one is drawn faster. */
    static LayerBuffer blank(LayerView view, boolean opaque) {
        int width = (int) Math.ceil(view.camera().width() * view.deviceScale());
        int height = (int) Math.ceil(view.camera().height() * view.deviceScale());
        return new LayerBuffer(
                new BufferedImage(width, height, opaque ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB_PRE),
                view);
    }

    /** Paints within a rectangle, pixels. */
    void paint(Rectangle clip, Consumer<DrawContext> painter) {
        Graphics2D graphics = graphics();
        graphics.setClip(clip);
        painter.accept(new DrawContext(graphics, view.camera(), view.palette()));
        graphics.dispose();
    }

    /** Makes a rectangle, pixels, transparent, unless the image is opaque. */
    void clear(Rectangle part) {
        if (image.getColorModel().hasAlpha()) {
            Graphics2D graphics = graphics();
            graphics.setComposite(AlphaComposite.Clear);
            graphics.fill(part);
            graphics.dispose();
        }
    }

    private Graphics2D graphics() {
        Graphics2D graphics = image.createGraphics();
        graphics.scale(view.deviceScale(), view.deviceScale());
        return graphics;
    }

    /** Returns this image for another view, with its content moved; what comes into view is not painted. */
    LayerBuffer moved(Point by, LayerView to) {
        Graphics2D graphics = image.createGraphics();
        graphics.setComposite(AlphaComposite.Src);
        graphics.copyArea(0, 0, image.getWidth(), image.getHeight(), (int) (by.x * view.deviceScale()), (int)
                (by.y * view.deviceScale()));
        graphics.dispose();
        return new LayerBuffer(image, to);
    }

    /** Returns the parts that come into view when the content moves; they may be empty. */
    List<Rectangle> exposedParts(Point by) {
        int width = view.camera().width();
        int height = view.camera().height();
        return List.of(
                new Rectangle(by.x > 0 ? 0 : width + by.x, 0, Math.abs(by.x), height),
                new Rectangle(0, by.y > 0 ? 0 : height + by.y, width, Math.abs(by.y)));
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
