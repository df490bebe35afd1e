package faultline.scenario;

import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/** Puts a user's own words into a complaint: on one line, and not more of them than a line holds. */
public final class Quoting {

    private static final int LONGEST = 60;
    private static final int MOST_NAMES = 12;

    private Quoting() {
    }

    /**
     * A text to be shown as the value that was given.
     *
     * @param text any text
     * @return in double quotes, on one line, cut where it is long
     */
    public static String quoted(String text) {
        String shown = text.length() > LONGEST ? text.substring(0, LONGEST) + "..." : text;
        return '"' + oneLine(shown) + '"';
    }

    /** A text with every control character replaced by a blank. */
    static String oneLine(String text) {
        return text.codePoints().map(c -> Character.isISOControl(c) || c == 0x2028 || c == 0x2029 ? ' ' : c)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append).toString();
    }

    /** The names that are allowed, the first dozen of them. */
    static String list(Collection<String> names) {
        List<String> first = names.stream().limit(MOST_NAMES).map(Quoting::oneLine).collect(Collectors.toList());
        String rest = names.size() > MOST_NAMES ? " and " + (names.size() - MOST_NAMES) + " more" : "";
        return String.join(", ", first) + rest;
    }
}
