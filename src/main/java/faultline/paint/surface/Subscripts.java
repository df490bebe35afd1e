package faultline.paint.surface;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Splits texts in which an underscore sets the letters after it as a subscript, as in t_D. Two underscores are a
 * literal one.
 */
final class Subscripts {

    /** The font size of a subscript, as a fraction of that of the text. */
    static final double SIZE_RATIO = 0.75;

    /** The shift of a subscript, as a fraction of the font size of the text. */
    static final double DROP_RATIO = 0.25;

    private static final Pattern SUBSCRIPT = Pattern.compile("__|_(\\p{Alnum}+)");

    private Subscripts() {}

    /**
     * A part of a text.
     *
     * @param text its letters
     * @param subscript whether they are a subscript
     */
    record TextRun(String text, boolean subscript) {}

    /** Returns the parts of a text, in order. */
    static List<TextRun> split(String text) {
        List<TextRun> runs = new ArrayList<>();
        StringBuilder plain = new StringBuilder();
        Matcher matcher = SUBSCRIPT.matcher(text);
        while (matcher.find()) {
            matcher.appendReplacement(plain, matcher.group(1) == null ? "_" : "");
            if (matcher.group(1) != null) {
                runs.add(new TextRun(plain.toString(), false));
                runs.add(new TextRun(matcher.group(1), true));
                plain.setLength(0);
            }
        }
        runs.add(new TextRun(matcher.appendTail(plain).toString(), false));
        runs.removeIf(run -> run.text().isEmpty());
        return runs;
    }
}
