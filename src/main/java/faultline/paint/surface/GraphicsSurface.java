package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.GraphicsDevice;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.util.List;

/**
 * A surface of pixels, or a printer's page. The user space of the graphics is the picture; its hints, colour, font and
 * stroke are changed.
 */
public record GraphicsSurface(Graphics2D graphics) implements Surface {

    /** A width of 0 is one pixel of the device. */
    private static final Stroke THINNEST_STROKE = new BasicStroke(0);

    /** Sets the rendering hints. */
    public GraphicsSurface {
        enableAntialiasing(graphics);
    }

    /** Sets the rendering hints of all pictures: antialiasing, and pure strokes, which move smoothly. */
    public static void enableAntialiasing(Graphics2D graphics) {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    @Override
    public void fill(Shape shape, Color colour) {
        graphics.setColor(colour);
        if (shape instanceof Rectangle) {
            fillPixels(shape);
        } else {
            graphics.fill(shape);
        }
    }

    /** Rectangles of whole pixels need no antialiasing, and filling them without it is several times faster. */
    private void fillPixels(Shape pixels) {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
        graphics.fill(pixels);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }

    @Override
    public void draw(Shape shape, Color colour, Stroke stroke) {
        graphics.setColor(colour);
        graphics.setStroke(stroke);
        graphics.draw(shape);
    }

    /** The thinnest lines without antialiasing are many times faster, but hardly visible on paper. */
    @Override
    public void drawThin(Shape lines, Color colour) {
        if (isPrinter()) {
            Surface.super.drawThin(lines, colour);
        } else {
            graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
            draw(lines, colour, THINNEST_STROKE);
            graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        }
    }

    private boolean isPrinter() {
        return deviceType() == GraphicsDevice.TYPE_PRINTER;
    }

    private int deviceType() {
        return graphics.getDeviceConfiguration().getDevice().getType();
    }

    @Override
    public void drawText(String text, Vector2 at, TextStyle style) {
        Font font = style.font();
        List<Subscripts.TextRun> runs = Subscripts.split(text);
        double width = runs.stream().mapToDouble(run -> width(run, font)).sum();
        AffineTransform before = graphics.getTransform();
        graphics.translate(at.x(), at.y());
        if (!style.horizontal()) {
            graphics.rotate(-Math.PI / 2);
        }
        double x = -width * style.anchor().share();
        for (Subscripts.TextRun run : runs) {
            double drop = run.subscript() ? Subscripts.DROP_RATIO * style.size() : 0;
            drawText(run.text(), x, drop, style.colour(), runFont(run, font));
            x += width(run, font);
        }
        graphics.setTransform(before);
    }

    private double width(Subscripts.TextRun run, Font font) {
        return runFont(run, font)
                .getStringBounds(run.text(), fontRenderContext())
                .getWidth();
    }

    private static Font runFont(Subscripts.TextRun run, Font font) {
        return run.subscript() ? font.deriveFont((float) (Subscripts.SIZE_RATIO * font.getSize2D())) : font;
    }

    @Override
    public void drawText(String text, double x, double y, Color colour, Font font) {
        graphics.setFont(font);
        graphics.setColor(colour);
        graphics.drawString(text, (float) x, (float) y);
    }

    @Override
    public void drawHaloedText(String text, double x, double y, Color colour, Color halo, Font font) {
        AffineTransform transform = graphics.getTransform();
        boolean upright =
                (transform.getType() & ~(AffineTransform.TYPE_TRANSLATION | AffineTransform.TYPE_UNIFORM_SCALE)) == 0;
        if (upright && isImageTarget()) {
            LabelSprite.of(text, font, colour, halo, transform.getScaleX()).paint(graphics, x, y);
        } else {
            drawOutlinedText(text, x, y, colour, halo, font);
        }
    }

    /** A screen may be slow to copy images to, and a printer is finer than any image. */
    private boolean isImageTarget() {
        return deviceType() == GraphicsDevice.TYPE_IMAGE_BUFFER;
    }

    private void drawOutlinedText(String text, double x, double y, Color colour, Color halo, Font font) {
        Shape outline = TextOutline.of(text, font, fontRenderContext(), x, y);
        draw(outline, halo, DrawContext.HALO_STROKE);
        fill(outline, colour);
    }

    @Override
    public FontRenderContext fontRenderContext() {
        return graphics.getFontRenderContext();
    }
}
