package faultline.gui.window;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Breaks sentences for message boxes, which would be as wide as the sentence otherwise. */
final class Lines {

    private static final int MOST = 80;
    private static final Pattern LINE = Pattern.compile("\\S.{0," + (MOST - 1) + "}(?=\\s|$)|\\S{1," + MOST + "}");

    private Lines() {
    }

    /** The sentence with line breaks in place of blanks, where possible within eighty letters; longer words are cut. */
    static String broken(String sentence) {
        StringBuilder lines = new StringBuilder();
        Matcher line = LINE.matcher(sentence);
        while (line.find()) {
            lines.append(lines.isEmpty() ? "" : "\n").append(line.group().strip());
        }
        return lines.toString();
    }
}
