package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.util.List;

/** The head of an arrow. */
public final class Arrowhead {

    private static final double LENGTH = 8;
    private static final double HALF_WIDTH = 3;

    private Arrowhead() {}

    /**
     * Draws a head.
     *
     * @param drawing where to
     * @param from where the arrow comes from, pixels
     * @param tip where it points to, pixels
     * @param pen of its shaft
     */
    public static void paint(Drawing drawing, Vector2 from, Vector2 tip, LineStyle pen) {
        Vector2 way = tip.minus(from);
        if (way.length() > 0) {
            Vector2 ahead = way.times(1 / way.length());
            Vector2 foot = tip.minus(ahead.times(LENGTH));
            Vector2 aside = ahead.perpendicular().times(HALF_WIDTH);
            drawing.fillPolygon(List.of(tip, foot.plus(aside), foot.minus(aside)), pen.colour());
        }
    }
}
