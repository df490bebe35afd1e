package faultline.gui.text;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Why the world refused something, in the user's language. The world gives its reasons in English, as a journal and a report keep them;
 * here each of them is known by its wording.
 */
public final class Refusals {

    private static final List<Refusal> KNOWN = List.of(
            new Refusal("(.+) cannot be put there: it would overlap the robot", "refused.robot"),
            new Refusal("the robot has no room for that platform: it would overlap (.+)", "refused.platform"),
            new Refusal("at most (\\d+) obstacles may move", "refused.moving"),
            new Refusal("there is no obstacle (.+)", "refused.obstacle"),
            new Refusal("the robot has no sensor (.+)", "refused.sensor"),
            new Refusal("(.+) has no such fault", "refused.fault"),
            new Refusal("(.+) is the name of the enclosing wall", "refused.enclosure"));

    private Refusals() {
    }

    /** A reason with one gap, and the key of its text. */
    private record Refusal(Pattern wording, String key) {

        Refusal(String wording, String key) {
            this(Pattern.compile(wording), key);
        }
    }

    /**
     * A reason for people.
     *
     * @param reason as the world gives it
     * @return the same in the user's language; a reason of another wording as it is
     */
    public static String text(String reason) {
        for (Refusal refusal : KNOWN) {
            Matcher matcher = refusal.wording().matcher(reason);
            if (matcher.matches()) {
                return Texts.text(refusal.key(), matcher.group(1));
            }
        }
        return reason;
    }
}
