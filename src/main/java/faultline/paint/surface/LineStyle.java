package faultline.paint.surface;

import java.awt.Color;

/**
 * What a line is drawn with.
 *
 * @param colour may be translucent
 * @param width pixels, positive
 * @param dash how it is broken
 */
public record LineStyle(Color colour, double width, DashPattern dash) {

    /**
     * A pen for lines that are not broken.
     *
     * @param colour may be translucent
     * @param width pixels, positive
     * @return the pen
     */
    public static LineStyle solid(Color colour, double width) {
        return new LineStyle(colour, width, DashPattern.SOLID);
    }
}
