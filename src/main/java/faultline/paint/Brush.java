package faultline.paint;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.GlyphVector;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;

/**
 * A graphics, the camera that it is looked at through and the colours that it is painted with. All shapes that a brush takes are in
 * pixels of the picture, so that lines keep their width at any zoom.
 *
 * @param graphics where pixels go; in the picture's user space
 * @param camera from the world to the picture
 * @param palette the colours
 */
public record Brush(Graphics2D graphics, Camera camera, Palette palette) {

    /** For labels in the picture. */
    static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    private static final Stroke HALO = new BasicStroke(3.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    private static final int HALO_ALPHA = 200;

    public Brush {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        // Pure strokes: normalised ones jump by half a pixel while they move.
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    /** A line of a width in pixels, with round ends and joins. */
    static Stroke solid(double width) {
        return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    /** A broken line of a width in pixels; dash and gap in pixels, seen as such because the ends are flat. */
    static Stroke dashed(double width, double dash, double gap) {
        return new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {(float) dash, (float) gap}, 0);
    }

    /** A shape of the world in the picture. */
    Shape onScreen(Shape world) {
        return camera.transform().createTransformedShape(world);
    }

    /** A shape of a frame within the world in the picture; {@code frame} carries it into the world. */
    Shape onScreen(Shape local, AffineTransform frame) {
        AffineTransform all = camera.transform();
        all.concatenate(frame);
        return all.createTransformedShape(local);
    }

    void fill(Shape shape, Color colour) {
        graphics.setColor(colour);
        graphics.fill(shape);
    }

    void draw(Shape shape, Color colour, Stroke stroke) {
        graphics.setColor(colour);
        graphics.setStroke(stroke);
        graphics.draw(shape);
    }

    /** A ring about a place, set off from whatever lies beneath by a halo of the canvas's colour. */
    void ring(double x, double y, double radius, double width, Color colour) {
        Shape circle = new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
        draw(circle, Palette.translucent(palette.canvas(), HALO_ALPHA), solid(width + 2));
        draw(circle, colour, solid(width));
    }

    /** The size of a text, pixels. */
    Rectangle2D measure(String text) {
        return FONT.getStringBounds(text, graphics.getFontRenderContext());
    }

    /** A text with its base line's left end at a place. */
    void text(String text, double x, double y, Color colour) {
        graphics.setFont(FONT);
        graphics.setColor(colour);
        graphics.drawString(text, (float) x, (float) y);
    }

    /** A text about a place, set off from whatever lies beneath by a halo of the canvas's colour. */
    void label(String text, double centreX, double centreY, Color colour) {
        GlyphVector glyphs = FONT.createGlyphVector(graphics.getFontRenderContext(), text);
        Rectangle2D bounds = glyphs.getVisualBounds();
        Shape outline = glyphs.getOutline((float) (centreX - bounds.getCenterX()), (float) (centreY - bounds.getCenterY()));
        draw(outline, Palette.translucent(palette.canvas(), HALO_ALPHA), HALO);
        fill(outline, colour);
    }
}
