package faultline.paint.surface;

import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;

/**
 * Where a brush leaves its marks: a grid of pixels, or a file of lines. All places are in pixels of the picture, y
 * down; what comes later lies on top.
 */
public interface Surface {

    /**
     * Fills the inside of a shape.
     *
     * @param shape pixels
     * @param colour may be translucent
     */
    void fill(Shape shape, Color colour);

    /**
     * Draws the outline of a shape.
     *
     * @param shape pixels
     * @param colour may be translucent
     * @param stroke the line's width, ends and dashes
     */
    void draw(Shape shape, Color colour, Stroke stroke);

    /**
     * Writes a line of text.
     *
     * @param text what to write
     * @param x of the left end of its base line
     * @param y of the left end of its base line
     * @param colour of the letters
     * @param font of the letters
     */
    void drawText(String text, double x, double y, Color colour, Font font);

    /**
     * Writes a line of text that is set off from whatever lies beneath.
     *
     * @param text what to write
     * @param x of the left end of its base line
     * @param y of the left end of its base line
     * @param colour of the letters
     * @param halo about the letters; may be translucent
     * @param font of the letters
     */
    void drawHaloedText(String text, double x, double y, Color colour, Color halo, Font font);

    /**
     * What texts are measured with.
     *
     * @return of this surface
     */
    FontRenderContext fontRenderContext();
}
