package faultline.paint.surface;

import java.awt.Color;

/**
 * Formats numbers and colours for SVG files. Coordinates have two decimals, so that the bytes depend on the picture
 * alone.
 */
final class SvgFormat {

    /** Similar fonts, first the one with which texts are measured. */
    static final String FONT_FAMILIES = "DejaVu Sans, Verdana, Arial, sans-serif";

    private SvgFormat() {}

    /**
     * Returns the attributes of a colour, which may be translucent, with a leading space; {@code attribute} is fill or
     * stroke.
     */
    static String colourAttributes(String attribute, Color colour) {
        String solid = " " + attribute + "=\"" + Palette.toHex(colour) + "\"";
        return colour.getAlpha() == 255
                ? solid
                : solid + " " + attribute + "-opacity=\"" + number(colour.getAlpha() / 255.0) + "\"";
    }

    /** Returns a finite number with at most two decimals, without trailing zeros or a sign on zero. */
    static String number(double value) {
        long hundredths = Math.round(value * 100);
        long rest = Math.abs(hundredths % 100);
        String sign = hundredths < 0 ? "-" : "";
        String decimals = rest == 0 ? "" : rest % 10 == 0 ? "." + rest / 10 : (rest < 10 ? ".0" : ".") + rest;
        return sign + Math.abs(hundredths / 100) + decimals;
    }
}
