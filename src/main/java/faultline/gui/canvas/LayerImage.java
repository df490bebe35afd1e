package faultline.gui.canvas;

import faultline.paint.Brush;
import faultline.paint.Camera;
import faultline.paint.Palette;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;

/**
 * A part of the picture kept as an image at the resolution of the device, so that it is as crisp as if it were painted.
 *
 * @param image its pixels are the device's
 * @param view what it was made for
 */
record LayerImage(BufferedImage image, View view) {

    /**
     * All that a kept part of the picture depends on besides the world.
     *
     * @param camera from the world to the picture
     * @param palette the colours
     * @param deviceScale device pixels per pixel
     */
    record View(Camera camera, Palette palette, double deviceScale) {
    }

    static LayerImage opaque(View view) {
        return new LayerImage(blank(view, BufferedImage.TYPE_INT_RGB), view);
    }

    static LayerImage transparent(View view) {
        return new LayerImage(blank(view, BufferedImage.TYPE_INT_ARGB_PRE), view);
    }

    private static BufferedImage blank(View view, int type) {
        int width = (int) Math.ceil(view.camera().width() * view.deviceScale());
        int height = (int) Math.ceil(view.camera().height() * view.deviceScale());
        return new BufferedImage(width, height, type);
    }

    /** Adds to the image. */
    void paint(Consumer<Brush> painter) {
        Graphics2D graphics = image.createGraphics();
        graphics.scale(view.deviceScale(), view.deviceScale());
        painter.accept(new Brush(graphics, view.camera(), view.palette()));
        graphics.dispose();
    }

    /** Shows the image, pixel for pixel. */
    void show(Graphics2D graphics) {
        Image pixels = image;
        graphics.drawImage(pixels, AffineTransform.getScaleInstance(1 / view.deviceScale(), 1 / view.deviceScale()), null);
    }
}
