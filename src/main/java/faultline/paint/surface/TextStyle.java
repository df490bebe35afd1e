package faultline.paint.surface;

import java.awt.Color;

/**
 * How a text is written.
 *
 * @param size of the font, pixels
 * @param colour of the letters
 * @param anchor which end of the text is at its place
 * @param bold whether in heavy letters
 * @param horizontal whether it runs to the right; otherwise it runs up
 */
public record TextStyle(double size, Color colour, Anchor anchor, boolean bold, boolean horizontal) {

    /** Which end of a text is at its place. */
    public enum Anchor {
        /** Its beginning. */
        START,
        /** Its middle. */
        MIDDLE,
        /** Its end. */
        END
    }

    /**
     * Plain text that runs to the right from its place.
     *
     * @param size of the font, pixels
     * @param colour of the letters
     * @return the style
     */
    public static TextStyle plain(double size, Color colour) {
        return new TextStyle(size, colour, Anchor.START, false, true);
    }

    /**
     * This style with another anchor.
     *
     * @param other which end is at the text's place
     * @return the same style otherwise
     */
    public TextStyle withAnchor(Anchor other) {
        return new TextStyle(size, colour, other, bold, horizontal);
    }

    /**
     * This style in heavy letters.
     *
     * @return the same style otherwise
     */
    public TextStyle withBold() {
        return new TextStyle(size, colour, anchor, true, horizontal);
    }

    /**
     * This style running up.
     *
     * @return the same style otherwise
     */
    public TextStyle rotated() {
        return new TextStyle(size, colour, anchor, bold, false);
    }

    /**
     * About how wide a text becomes. Letters are counted, not measured, so that a layout is the same with every font.
     *
     * @param text one line
     * @return pixels
     */
    public double estimateWidth(String text) {
        return size
                * (bold ? 1.1 : 1)
                * text.chars().mapToDouble(TextStyle::emWidth).sum();
    }

    /** The width of a letter in sizes of the font, as in common sans-serif fonts, rather too wide than too narrow. */
    private static double emWidth(int letter) {
        if ("il.,:;'|!jI".indexOf(letter) >= 0) {
            return 0.32;
        }
        if (" ()[]ftr/-".indexOf(letter) >= 0) {
            return 0.42;
        }
        if ("mwMW%=+<>\u2264\u2265\u2212".indexOf(letter) >= 0) {
            return 0.9;
        }
        return Character.isUpperCase(letter) ? 0.72 : 0.62;
    }
}
