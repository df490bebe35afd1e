package faultline.paint.surface;

import java.awt.Color;
import java.awt.Font;
import java.util.ArrayList;
import java.util.List;

/**
 * The style of a line of text.
 *
 * @param size the size of the font, pixels
 * @param colour the colour of the letters
 * @param anchor the point of the text that is at its position
 * @param bold whether the font is bold
 * @param horizontal whether the text runs to the right; otherwise it runs upwards
 */
public record TextStyle(double size, Color colour, Anchor anchor, boolean bold, boolean horizontal) {

    /** The point of a text that is at its position. */
    public enum Anchor {
        /** Its start. */
        START(0),
        /** Its middle. */
        MIDDLE(0.5),
        /** Its end. */
        END(1);

        private final double share;

        Anchor(double share) {
            this.share = share;
        }

        /** Returns the share of the width of the text that is before this point. */
        double share() {
            return share;
        }
    }

    /** Returns the style of plain text that starts at its position and runs to the right; size in pixels. */
    public static TextStyle plain(double size, Color colour) {
        return new TextStyle(size, colour, Anchor.START, false, true);
    }

    /** Returns this style with another anchor. */
    public TextStyle withAnchor(Anchor other) {
        return new TextStyle(size, colour, other, bold, horizontal);
    }

    public TextStyle withBold() {
        return new TextStyle(size, colour, anchor, true, horizontal);
    }

    /** Returns this style running upwards. */
    public TextStyle rotated() {
        return new TextStyle(size, colour, anchor, bold, false);
    }

    /** Returns the font of this style, for surfaces of pixels. */
    Font font() {
        return new Font(Font.SANS_SERIF, bold ? Font.BOLD : Font.PLAIN, 1).deriveFont((float) size);
    }

    /** Returns a text with each underscore doubled, so that a surface draws it literally. */
    public static String literal(String text) {
        return text.replace("_", "__");
    }

    /**
     * Estimates the width of a line of text, pixels. Letters are counted, not measured, so that a layout is the same
     * with every font.
     */
    public double estimateWidth(String text) {
        return size
                * (bold ? 1.1 : 1)
                * text.chars().mapToDouble(TextStyle::emWidth).sum();
    }

    /** Returns the lines into which a text is broken at its spaces, so that each fits a width in pixels by estimate. */
    public List<String> wrap(String text, double width) {
        List<String> lines = new ArrayList<>();
        for (String word : text.strip().split("\\s+")) {
            String last = lines.isEmpty() ? "" : lines.get(lines.size() - 1) + " " + word;
            if (!last.isEmpty() && estimateWidth(last) <= width) {
                lines.set(lines.size() - 1, last);
            } else {
                lines.add(word);
            }
        }
        return lines;
    }

    /** Returns the width of a letter in units of the font size, as in common sans-serif fonts or a little wider. */
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
