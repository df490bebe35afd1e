package faultline.paint.surface;

import java.awt.Color;
import java.util.Locale;

/**
 * How numbers, colours and words are written in an SVG file. Places go to a hundredth of a pixel, so that the bytes
 * hang on nothing but the picture.
 */
public final class SvgFormat {

    /** Fonts that look alike, the one that pictures are measured with first. */
    public static final String FONT_FAMILIES = "DejaVu Sans, Verdana, Arial, sans-serif";

    private SvgFormat() {}

    /**
     * The attributes of a colour.
     *
     * @param attribute fill or stroke
     * @param colour may be translucent
     * @return with a blank in front
     */
    public static String colourAttributes(String attribute, Color colour) {
        String solid = " " + attribute + "=\"" + toHex(colour) + "\"";
        return colour.getAlpha() == 255
                ? solid
                : solid + " " + attribute + "-opacity=\"" + number(colour.getAlpha() / 255.0) + "\"";
    }

    /** A colour as {@code #rrggbb}. */
    static String toHex(Color colour) {
        return String.format(Locale.ROOT, "#%06x", colour.getRGB() & 0xFFFFFF);
    }

    /**
     * A number with at most two decimals, no zeros at the end, and no sign on a zero.
     *
     * @param value finite
     * @return its text
     */
    public static String number(double value) {
        long hundredths = Math.round(value * 100);
        long rest = Math.abs(hundredths % 100);
        String sign = hundredths < 0 ? "-" : "";
        String decimals = rest == 0 ? "" : rest % 10 == 0 ? "." + rest / 10 : (rest < 10 ? ".0" : ".") + rest;
        return sign + Math.abs(hundredths / 100) + decimals;
    }

    /**
     * A text that is taken as it is read.
     *
     * @param text any
     * @return with what SVG takes for itself written otherwise
     */
    public static String escape(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
