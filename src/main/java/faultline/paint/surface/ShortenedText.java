package faultline.paint.surface;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.font.FontRenderContext;

/** Shortens texts that are too wide, Latin ones as the labels of Swing do. */
public final class ShortenedText {

    private static final String DOTS = "...";

    private ShortenedText() {}

    /** Returns a text, with dots in place of its end if it is wider than a width, pixels. */
    public static String of(String text, FontMetrics metrics, double width) {
        return of(text, metrics.getFont(), metrics.getFontRenderContext(), width);
    }

    /** Returns the same for a font, given how texts are measured. */
    public static String of(String text, Font font, FontRenderContext context, double width) {
        if (text.isEmpty() || width(text, font, context) <= width) {
            return text;
        }
        double room = width - width(DOTS, font, context);
        int fitting = 0;
        // A longer part would be wider, because few characters are narrower than a pixel.
        int limit = (int) Math.min(text.length(), Math.max(0, room));
        while (fitting < limit) {
            int middle = (fitting + limit + 1) / 2;
            if (font.getStringBounds(text, 0, middle, context).getWidth() <= room) {
                fitting = middle;
            } else {
                limit = middle - 1;
            }
        }
        while (fitting > 0 && isContinued(text, fitting)) {
            fitting--;
        }
        return text.substring(0, fitting) + DOTS;
    }

    /** Returns whether what is before an index and what is after it are parts of one letter. */
    private static boolean isContinued(String text, int index) {
        return index < text.length()
                && (Character.isLowSurrogate(text.charAt(index))
                        || Character.getType(text.charAt(index)) == Character.NON_SPACING_MARK);
    }

    /** Returns the width of a text in whole pixels, as that of font metrics, with which callers compare theirs. */
    private static long width(String text, Font font, FontRenderContext context) {
        return Math.round(font.getStringBounds(text, context).getWidth());
    }
}
