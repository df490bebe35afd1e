package faultline.paint.surface;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;

/**
 * The style of a line; the width is in pixels, and the colour may be translucent. Solid lines have round ends, broken
 * ones have flat ends.
 */
public record LineStyle(Color colour, double width, DashPattern dash) {

    /** Returns a solid line style; width in pixels, positive. */
    public static LineStyle solid(Color colour, double width) {
        return new LineStyle(colour, width, DashPattern.SOLID);
    }

    /** Returns this style with another width in pixels, positive. */
    public LineStyle withWidth(double other) {
        return new LineStyle(colour, other, dash);
    }

    public BasicStroke stroke() {
        List<Double> lengths = dash.lengths();
        if (lengths.isEmpty()) {
            return DrawContext.solidStroke(width);
        }
        float[] dashes = new float[lengths.size()];
        for (int i = 0; i < dashes.length; i++) {
            dashes[i] = lengths.get(i).floatValue();
        }
        return new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0);
    }
}
