package faultline.paint.plot;

import faultline.geometry.Vec;
import java.util.List;

/** The head of an arrow. */
public final class Arrowhead {

    private static final double LENGTH = 8;
    private static final double HALF_WIDTH = 3;

    private Arrowhead() {
    }

    /**
     * Draws a head.
     *
     * @param drawing where to
     * @param from where the arrow comes from, pixels
     * @param tip where it points to, pixels
     * @param pen of its shaft
     */
    public static void paint(Drawing drawing, Vec from, Vec tip, Pen pen) {
        Vec way = tip.minus(from);
        if (way.length() > 0) {
            Vec ahead = way.times(1 / way.length());
            Vec foot = tip.minus(ahead.times(LENGTH));
            Vec aside = ahead.perpendicular().times(HALF_WIDTH);
            drawing.fill(List.of(tip, foot.plus(aside), foot.minus(aside)), pen.colour());
        }
    }
}
