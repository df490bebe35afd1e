package faultline.paint.surface;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;

/**
 * A surface, the camera that it is looked at through and the colours that it is painted with. All shapes that a brush
 * takes are in pixels of the picture, so that lines keep their width at any zoom.
 *
 * @param surface where the marks go
 * @param camera from the world to the picture
 * @param palette the colours
 * @param font of the letters
 */
public record DrawContext(Surface surface, Camera camera, Palette palette, Font font) {

    /** For labels in files. */
    public static final Font DEFAULT_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    /** About letters that lie on whatever is beneath. */
    public static final Stroke HALO_STROKE = new BasicStroke(3.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);

    private static final int HALO_ALPHA = 200;

    /**
     * A brush for pixels that letters as in files.
     *
     * @param graphics where pixels go; in the picture's user space
     * @param camera from the world to the picture
     * @param palette the colours
     */
    public DrawContext(Graphics2D graphics, Camera camera, Palette palette) {
        this(new GraphicsSurface(graphics), camera, palette, DEFAULT_FONT);
    }

    /**
     * The same with another font.
     *
     * @param other the font
     * @return a brush for the same surface
     */
    public DrawContext withFont(Font other) {
        return new DrawContext(surface, camera, palette, other);
    }

    /** A length that goes along with the letters; pixels in files and here. */
    public double scaleToFont(double pixels) {
        return pixels * font.getSize2D() / DEFAULT_FONT.getSize2D();
    }

    /** A line of a width in pixels, with round ends and joins. */
    public static Stroke solidStroke(double width) {
        return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    /** A broken line of a width in pixels; dash and gap in pixels, seen as such because the ends are flat. */
    public static Stroke dashedStroke(double width, double dash, double gap) {
        return new BasicStroke(
                (float) width,
                BasicStroke.CAP_BUTT,
                BasicStroke.JOIN_ROUND,
                1,
                new float[] {(float) dash, (float) gap},
                0);
    }

    /** A shape of the world in the picture. */
    public Shape toScreen(Shape world) {
        return camera.transform().createTransformedShape(world);
    }

    /** A shape of a frame within the world in the picture; {@code frame} carries it into the world. */
    public Shape toScreen(Shape local, AffineTransform frame) {
        AffineTransform all = camera.transform();
        all.concatenate(frame);
        return all.createTransformedShape(local);
    }

    public void fill(Shape shape, Color colour) {
        surface.fill(shape, colour);
    }

    public void draw(Shape shape, Color colour, Stroke stroke) {
        surface.draw(shape, colour, stroke);
    }

    /** A ring about a place, set off from whatever lies beneath by a halo of the canvas's colour. */
    public void drawRing(double x, double y, double radius, double width, Color colour) {
        Shape circle = new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
        draw(circle, Palette.withAlpha(palette.canvas(), HALO_ALPHA), solidStroke(width + 2));
        draw(circle, colour, solidStroke(width));
    }

    /** The size of a text, pixels. */
    public Rectangle2D measureText(String text) {
        return font.getStringBounds(text, surface.fontRenderContext());
    }

    /** A text with its base line's left end at a place. */
    public void drawText(String text, double x, double y, Color colour) {
        surface.drawText(text, x, y, colour, font);
    }

    /** A text about a place, set off from whatever lies beneath by a halo of the canvas's colour. */
    public void drawLabel(String text, double centreX, double centreY, Color colour) {
        Rectangle2D bounds =
                font.createGlyphVector(surface.fontRenderContext(), text).getVisualBounds();
        surface.drawHaloedText(
                text,
                centreX - bounds.getCenterX(),
                centreY - bounds.getCenterY(),
                colour,
                Palette.withAlpha(palette.canvas(), HALO_ALPHA),
                font);
    }
}
