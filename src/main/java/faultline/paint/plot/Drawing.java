package faultline.paint.plot;

import faultline.geometry.Vec;
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
    void stroke(List<Vec> points, boolean closed, Pen pen);

    /**
     * Fills the inside of a closed line.
     *
     * @param points in order
     * @param colour may be translucent
     */
    void fill(List<Vec> points, Color colour);

    /**
     * Draws a circle.
     *
     * @param centre pixels
     * @param radius pixels
     * @param pen what with
     */
    void ring(Vec centre, double radius, Pen pen);

    /**
     * Fills a circle.
     *
     * @param centre pixels
     * @param radius pixels
     * @param colour may be translucent
     */
    void disc(Vec centre, double radius, Color colour);

    /**
     * Writes a line of text.
     *
     * @param text what to write; an underscore sets the letters after it as an index: t_D
     * @param at where its base line's anchor is, pixels
     * @param style how
     */
    void text(String text, Vec at, TextStyle style);
}
