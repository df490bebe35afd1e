package faultline.paint.surface;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Texts in which an underscore sets the letters after it lower and smaller, as in t_D. */
final class Subscripts {

    /** The size of lowered letters, as a share of the text's. */
    static final double SIZE_RATIO = 0.75;

    /** How far they are lowered, as a share of the text's size. */
    static final double DROP_RATIO = 0.25;

    private static final Pattern SUBSCRIPT = Pattern.compile("_(\\p{Alnum}+)");

    private Subscripts() {}

    /**
     * A stretch of a text.
     *
     * @param text its letters
     * @param subscript whether they are set lower
     */
    record TextRun(String text, boolean subscript) {}

    /** The stretches of a text, in order. */
    static List<TextRun> split(String text) {
        List<TextRun> runs = new ArrayList<>();
        Matcher matcher = SUBSCRIPT.matcher(text);
        int done = 0;
        while (matcher.find()) {
            runs.add(new TextRun(text.substring(done, matcher.start()), false));
            runs.add(new TextRun(matcher.group(1), true));
            done = matcher.end();
        }
        runs.add(new TextRun(text.substring(done), false));
        runs.removeIf(run -> run.text().isEmpty());
        return runs;
    }
}
