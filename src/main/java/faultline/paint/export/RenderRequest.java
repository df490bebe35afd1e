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
import java.util.List;
import java.util.Set;

/**
 * A complete description of the picture of a frame: the part of the world, the layers and texts, and the reference runs
 * to show. It can be rendered on any thread, as pixels of any resolution or as SVG.
 */
public record RenderRequest(
        Frame frame, Camera camera, Palette palette, ScenePainter painter, List<ReferenceOverlay> references) {

    public RenderRequest {
        references = List.copyOf(references);
    }

    /** Creates a request without reference runs, in English. */
    public RenderRequest(Frame frame, Camera camera, Palette palette, Set<Layer> layers) {
        this(frame, camera, palette, new ScenePainter(layers, SceneLabels.ENGLISH), List.of());
    }

    /** Returns the same request for another frame. */
    public RenderRequest withFrame(Frame other) {
        return new RenderRequest(other, camera, palette, painter, references);
    }

    /** Paints the picture on graphics whose user space is the picture. */
    public void paint(Graphics2D graphics) {
        painter.paint(new DrawContext(graphics, camera, palette), frame, references);
    }

    /** Renders the picture as a new opaque image; resolution in pixels of the image per pixel of the picture. */
    public BufferedImage toImage(double resolution) {
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(camera.width() * resolution),
                (int) Math.ceil(camera.height() * resolution),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        try {
            graphics.scale(resolution, resolution);
            paint(graphics);
        } finally {
            graphics.dispose();
        }
        return image;
    }

    /** Returns the text of an SVG file. */
    public String toSvg() {
        SvgSurface surface = new SvgSurface(camera.width(), camera.height());
        DrawContext context = new DrawContext(surface, camera, palette, DrawContext.DEFAULT_FONT);
        painter.paint(context, frame, references);
        return surface.toSvg();
    }
}
