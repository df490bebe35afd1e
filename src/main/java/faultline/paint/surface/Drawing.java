package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.Color;
import java.util.List;

/** Where a picture goes. Places are in pixels from the upper left corner, y down; what is told later lies on top. */
public interface Drawing {

    /**
     * Draws a line through points.
     *
     * @param points in order; fewer than two draw nothing
     * @param closed whether the last is joined to the first
     * @param pen what with
     */
    void drawPolyline(List<Vector2> points, boolean closed, LineStyle pen);

    /**
     * Fills the inside of a closed line.
     *
     * @param points in order
     * @param colour may be translucent
     */
    void fillPolygon(List<Vector2> points, Color colour);

    /**
     * Draws a circle.
     *
     * @param centre pixels
     * @param radius pixels
     * @param pen what with
     */
    void drawCircle(Vector2 centre, double radius, LineStyle pen);

    /**
     * Fills a circle.
     *
     * @param centre pixels
     * @param radius pixels
     * @param colour may be translucent
     */
    void fillCircle(Vector2 centre, double radius, Color colour);

    /**
     * Writes a line of text.
     *
     * @param text what to write; an underscore sets the letters after it as an index: t_D
     * @param at where its base line's anchor is, pixels
     * @param style how
     */
    void drawText(String text, Vector2 at, TextStyle style);
}
