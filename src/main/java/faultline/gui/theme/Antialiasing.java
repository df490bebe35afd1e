package faultline.gui.theme;

import java.awt.BasicStroke;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.RoundRectangle2D;
import java.util.function.Consumer;

/** Painting with smooth edges. */
public final class Antialiasing {

    /** The diameter of the corners of buttons and fields, pixels. */
    public static final double CORNER_DIAMETER = 8;

    private Antialiasing() {}

    /**
     * Paints on a graphics of its own, so that no hint or stroke leaks to other painters.
     *
     * @param graphics where to
     * @param painting what to paint
     */
    public static void paint(Graphics graphics, Consumer<Graphics2D> painting) {
        Graphics2D own = (Graphics2D) graphics.create();
        try {
            own.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            own.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            own.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
            painting.accept(own);
        } finally {
            own.dispose();
        }
    }

    /**
     * A rectangle with round corners whose one-pixel outline falls on whole pixels.
     *
     * @param x left edge
     * @param y upper edge
     * @param width the outline included
     * @param height the outline included
     * @return the middle of the outline
     */
    public static Shape roundedRectangle(double x, double y, double width, double height) {
        return new RoundRectangle2D.Double(x + 0.5, y + 0.5, width - 1, height - 1, CORNER_DIAMETER, CORNER_DIAMETER);
    }

    /**
     * A line with round ends and joins.
     *
     * @param width pixels
     * @return the stroke
     */
    public static Stroke roundStroke(double width) {
        return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }
}
