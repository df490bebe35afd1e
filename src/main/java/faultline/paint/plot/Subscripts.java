package faultline.paint.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Texts in which an underscore sets the letters after it lower and smaller, as in t_D. */
final class Subscripts {

    /** The size of lowered letters, as a share of the text's. */
    static final double SIZE = 0.75;

    /** How far they are lowered, as a share of the text's size. */
    static final double DROP = 0.25;

    private static final Pattern LOWERED = Pattern.compile("_(\\p{Alnum}+)");

    private Subscripts() {
    }

    /**
     * A stretch of a text.
     *
     * @param text its letters
     * @param lowered whether they are set lower
     */
    record Run(String text, boolean lowered) {
    }

    /** The stretches of a text, in order. */
    static List<Run> runs(String text) {
        List<Run> runs = new ArrayList<>();
        Matcher matcher = LOWERED.matcher(text);
        int done = 0;
        while (matcher.find()) {
            runs.add(new Run(text.substring(done, matcher.start()), false));
            runs.add(new Run(matcher.group(1), true));
            done = matcher.end();
        }
        runs.add(new Run(text.substring(done), false));
        runs.removeIf(run -> run.text().isEmpty());
        return runs;
    }
}
