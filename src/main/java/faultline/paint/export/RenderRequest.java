package faultline.paint.export;

import faultline.engine.Frame;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ReferenceOverlay;
import faultline.paint.scene.SceneLabels;
import faultline.paint.scene.ScenePainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.SvgSurface;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.Set;

/**
 * All that a picture of a frame hangs on, so that it can be made on any thread, as pixels of any fineness or as lines.
 *
 * @param frame what to paint
 * @param camera what part of the world, and how large the picture is
 * @param palette the colours; {@link Palette#LIGHT} for files
 * @param painter the layers that show, and the words in them
 * @param reference an earlier run beside the frame's, empty for none
 */
public record RenderRequest(
        Frame frame, Camera camera, Palette palette, ScenePainter painter, Optional<ReferenceOverlay> reference) {

    /**
     * A picture without an earlier run, in English.
     *
     * @param frame what to paint
     * @param camera what part of the world, and how large the picture is
     * @param palette the colours
     * @param layers the layers that show
     */
    public RenderRequest(Frame frame, Camera camera, Palette palette, Set<Layer> layers) {
        this(frame, camera, palette, new ScenePainter(layers, SceneLabels.ENGLISH), Optional.empty());
    }

    /**
     * The same view of another moment.
     *
     * @param other what to paint
     * @return the same shot otherwise
     */
    public RenderRequest withFrame(Frame other) {
        return new RenderRequest(other, camera, palette, painter, reference);
    }

    /**
     * Paints the picture.
     *
     * @param graphics whose user space is the picture
     */
    public void paint(Graphics2D graphics) {
        paint(new DrawContext(graphics, camera, palette));
    }

    private void paint(DrawContext brush) {
        painter.paint(brush, frame, reference);
    }

    /**
     * The picture as pixels.
     *
     * @param fineness how many of them go to each side of a pixel of the camera's picture, positive
     * @return a new opaque picture
     */
    public BufferedImage toImage(double fineness) {
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(camera.width() * fineness),
                (int) Math.ceil(camera.height() * fineness),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        try {
            graphics.scale(fineness, fineness);
            paint(graphics);
        } finally {
            graphics.dispose();
        }
        return image;
    }

    /**
     * The picture as lines.
     *
     * @return the text of an SVG file
     */
    public String toSvg() {
        SvgSurface surface = new SvgSurface(camera.width(), camera.height());
        paint(new DrawContext(surface, camera, palette, DrawContext.DEFAULT_FONT));
        return surface.toSvg();
    }
}
