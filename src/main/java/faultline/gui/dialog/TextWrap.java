package faultline.gui.dialog;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Breaks sentences for message boxes, which would be as wide as the sentence otherwise. */
final class TextWrap {

    private static final int MAX_LINE_LENGTH = 80;
    private static final Pattern LINE =
            Pattern.compile("\\S.{0," + (MAX_LINE_LENGTH - 1) + "}(?=\\s|$)|\\S{1," + MAX_LINE_LENGTH + "}");

    private TextWrap() {}

    /** The sentence with line breaks in place of blanks, where possible within eighty letters; longer words are cut. */
    static String wrap(String sentence) {
        StringBuilder lines = new StringBuilder();
        Matcher line = LINE.matcher(sentence);
        while (line.find()) {
            lines.append(lines.isEmpty() ? "" : "\n").append(line.group().strip());
        }
        return lines.toString();
    }
}
