package faultline.gui.theme;

import faultline.paint.surface.GraphicsSurface;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.RoundRectangle2D;
import java.util.function.Consumer;

/** Antialiased painting. */
public final class Antialiasing {

    /** The diameter of the corners of buttons and fields, pixels. */
    public static final double CORNER_DIAMETER = 8;

    private Antialiasing() {}

    /** Paints on a copy of the graphics, so that changes to it do not affect other painters. */
    public static void paint(Graphics graphics, Consumer<Graphics2D> painting) {
        Graphics2D own = (Graphics2D) graphics.create();
        try {
            GraphicsSurface.enableAntialiasing(own);
            painting.accept(own);
        } finally {
            own.dispose();
        }
    }

    /**
     * Returns the centre line of the one-pixel outline of a rounded rectangle, aligned with the pixel grid. The size of
     * the rectangle includes the outline.
     */
    public static Shape roundedRectangle(double x, double y, double width, double height) {
        return new RoundRectangle2D.Double(x + 0.5, y + 0.5, width - 1, height - 1, CORNER_DIAMETER, CORNER_DIAMETER);
    }
}
