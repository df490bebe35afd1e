package faultline.gui.text;

import java.awt.FontMetrics;
import java.awt.font.LineBreakMeasurer;
import java.awt.font.TextAttribute;
import java.text.AttributedString;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Wraps sentences for message boxes and tool tips. */
public final class TextWrap {

    private static final int MAX_LINE_LENGTH = 80;
    private static final Pattern LINE =
            Pattern.compile("\\S.{0," + (MAX_LINE_LENGTH - 1) + "}(?=\\s|$)|\\S{1," + MAX_LINE_LENGTH + "}");

    private TextWrap() {}

    /** Returns the sentence with line breaks so that lines have at most eighty characters; longer words are broken. */
    public static String wrap(String sentence) {
        StringBuilder lines = new StringBuilder();
        Matcher line = LINE.matcher(sentence);
        while (line.find()) {
            lines.append(lines.isEmpty() ? "" : "\n").append(line.group().strip());
        }
        return lines.toString();
    }

    /**
     * Returns the lines of a text, each not wider than a number of pixels; longer words are broken. The line breaks of
     * the text are kept.
     */
    public static List<String> lines(String text, FontMetrics metrics, int width) {
        return text.lines()
                .flatMap(line ->
                        metrics.stringWidth(line) <= width ? Stream.of(line) : wrapped(line, metrics, width).stream())
                .toList();
    }

    private static List<String> wrapped(String line, FontMetrics metrics, int width) {
        AttributedString text = new AttributedString(line, Map.of(TextAttribute.FONT, metrics.getFont()));
        LineBreakMeasurer measurer = new LineBreakMeasurer(text.getIterator(), metrics.getFontRenderContext());
        List<String> lines = new ArrayList<>();
        int start = 0;
        while (start < line.length()) {
            int end = measurer.nextOffset(width);
            measurer.setPosition(end);
            lines.add(line.substring(start, end).strip());
            start = end;
        }
        return lines;
    }
}
