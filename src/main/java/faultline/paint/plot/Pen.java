package faultline.paint.plot;

import java.awt.Color;

/**
 * What a line is drawn with.
 *
 * @param colour may be translucent
 * @param width pixels, positive
 * @param dash how it is broken
 */
public record Pen(Color colour, double width, Dash dash) {

    /**
     * A pen for lines that are not broken.
     *
     * @param colour may be translucent
     * @param width pixels, positive
     * @return the pen
     */
    public static Pen solid(Color colour, double width) {
        return new Pen(colour, width, Dash.SOLID);
    }
}
