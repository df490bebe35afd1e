package faultline.gui.text;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Wraps sentences for message boxes. */
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
}
