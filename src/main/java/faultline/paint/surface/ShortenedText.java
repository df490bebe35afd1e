package faultline.paint.surface;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.font.FontRenderContext;
import java.awt.font.TextAttribute;
import java.awt.font.TextMeasurer;
import java.text.AttributedString;
import java.util.Map;

/** Shortens texts that are too wide, as the labels of Swing do. */
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
        AttributedString styled = new AttributedString(text, Map.of(TextAttribute.FONT, font));
        int end = room <= 0 ? 0 : new TextMeasurer(styled.getIterator(), context).getLineBreakIndex(0, (float) room);
        return text.substring(0, end) + DOTS;
    }

    /** Returns the width of a text in whole pixels, as that of font metrics, with which callers compare theirs. */
    private static long width(String text, Font font, FontRenderContext context) {
        return Math.round(font.getStringBounds(text, context).getWidth());
    }
}
