package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;

/**
 * A surface with a camera, colours and a font. All shapes are in pixels of the picture, so that lines keep their width
 * at any zoom.
 */
public record DrawContext(Surface surface, Camera camera, Palette palette, Font font) {

    /** The font of labels in files. */
    public static final Font DEFAULT_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    /** How text is measured where there is no surface. */
    public static final FontRenderContext FONT_CONTEXT = new FontRenderContext(null, true, true);

    /** The stroke of halos around letters. */
    public static final BasicStroke HALO_STROKE = solidStroke(3.5);

    private static final int HALO_ALPHA = 200;
    private static final Stroke CROSS_STROKE = solidStroke(2);

    /** Creates a context that paints pixels, with the font of files; the user space of the graphics is the picture. */
    public DrawContext(Graphics2D graphics, Camera camera, Palette palette) {
        this(new GraphicsSurface(graphics), camera, palette, DEFAULT_FONT);
    }

    /** Returns this context with another font. */
    public DrawContext withFont(Font other) {
        return new DrawContext(surface, camera, palette, other);
    }

    /** Returns a length that is given for the font of files, scaled to this font; pixels. */
    public double scaleToFont(double pixels) {
        return pixels * font.getSize2D() / DEFAULT_FONT.getSize2D();
    }

    /** Returns a solid stroke with round ends and joins; width in pixels. */
    public static BasicStroke solidStroke(double width) {
        return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    /** Returns a dashed stroke with flat ends; width, dash and gap in pixels. */
    public static Stroke dashedStroke(double width, double dash, double gap) {
        return new BasicStroke(
                (float) width,
                BasicStroke.CAP_BUTT,
                BasicStroke.JOIN_ROUND,
                1,
                new float[] {(float) dash, (float) gap},
                0);
    }

    /** Returns a shape of the world in the picture. */
    public Shape toScreen(Shape world) {
        return camera.transform().createTransformedShape(world);
    }

    /** Returns a shape in the picture; {@code frame} transforms its local coordinates to the world. */
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

    /** Draws thousands of lines in little time, where lines of pixels may be thin and have rough edges. */
    public void drawThin(Shape lines, Color colour) {
        surface.drawThin(lines, colour);
    }

    /** Draws a ring with a halo of the canvas's colour. */
    public void drawRing(Vector2 centre, double radius, double width, Color colour) {
        Shape circle = Shapes.circle(centre, radius);
        draw(circle, Palette.withAlpha(palette.canvas(), HALO_ALPHA), solidStroke(width + 2));
        draw(circle, colour, solidStroke(width));
    }

    /** Draws the diagonals of a rectangle. */
    public void drawCross(Rectangle2D box, Color colour) {
        draw(new Line2D.Double(box.getMinX(), box.getMinY(), box.getMaxX(), box.getMaxY()), colour, CROSS_STROKE);
        draw(new Line2D.Double(box.getMinX(), box.getMaxY(), box.getMaxX(), box.getMinY()), colour, CROSS_STROKE);
    }

    /** Returns the size of a text, pixels. */
    public Rectangle2D measureText(String text) {
        return font.getStringBounds(text, surface.fontRenderContext());
    }

    /** Returns a text, with dots in place of its end if it is wider than a width, pixels. */
    public String shortenText(String text, double width) {
        return ShortenedText.of(text, font, surface.fontRenderContext(), width);
    }

    /** Draws a text; x and y are those of the start of its baseline. */
    public void drawText(String text, double x, double y, Color colour) {
        surface.drawText(text, x, y, colour, font);
    }

    /** Draws a text around a centre, with a halo of the canvas's colour. */
    public void drawLabel(String text, double centreX, double centreY, Color colour) {
        Rectangle2D bounds = TextOutline.bounds(text, font, surface.fontRenderContext());
        surface.drawHaloedText(
                text,
                centreX - bounds.getCenterX(),
                centreY - bounds.getCenterY(),
                colour,
                Palette.withAlpha(palette.canvas(), HALO_ALPHA),
                font);
    }
}
