package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;

/**
 * The target of all drawing: pixels, or an SVG file. All coordinates are in pixels of the picture, from its upper left
 * corner, y down. Later marks cover earlier ones.
 */
public interface Surface {

    /** Fills a shape; the colour may be translucent. */
    void fill(Shape shape, Color colour);

    /** Draws the outline of a shape; the colour may be translucent. */
    void draw(Shape shape, Color colour, Stroke stroke);

    /** Draws the outline of a shape. */
    default void draw(Shape shape, LineStyle style) {
        draw(shape, style.colour(), style.stroke());
    }

    /** Draws thousands of lines in little time, where lines of pixels may be thin and have rough edges. */
    default void drawThin(Shape lines, Color colour) {
        draw(lines, colour, new BasicStroke(1));
    }

    /**
     * Draws a line of text.
     *
     * @param text an underscore sets the letters after it as a subscript: t_D
     * @param at the position of the text's anchor on its baseline
     * @param style its size, colour, anchor and direction
     */
    void drawText(String text, Vector2 at, TextStyle style);

    /** Draws a line of text literally; x and y are those of the left end of its baseline. */
    void drawText(String text, double x, double y, Color colour, Font font);

    /**
     * Draws a line of text literally, with a halo that separates it from what is below; x and y are those of the left
     * end of its baseline.
     */
    void drawHaloedText(String text, double x, double y, Color colour, Color halo, Font font);

    /** Returns the context for measuring texts on this surface. */
    FontRenderContext fontRenderContext();
}
