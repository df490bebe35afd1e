package faultline.io;

import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/** Puts a user's own words into a complaint: on one line, and not more of them than a line holds. */
public final class MessageText {

    private static final int MAX_QUOTED_LENGTH = 60;
    private static final int MAX_NAMES = 12;

    private MessageText() {}

    /**
     * A text to be shown as the value that was given.
     *
     * @param text any text
     * @return in double quotes, on one line, cut where it is long
     */
    public static String quoted(String text) {
        String shown = text.length() > MAX_QUOTED_LENGTH ? text.substring(0, MAX_QUOTED_LENGTH) + "..." : text;
        return '"' + oneLine(shown) + '"';
    }

    /** A text with every control character replaced by a blank. */
    public static String oneLine(String text) {
        return text.codePoints()
                .map(c -> Character.isISOControl(c) || c == 0x2028 || c == 0x2029 ? ' ' : c)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
    }

    /** The names that are allowed, the first dozen of them. */
    public static String joinNames(Collection<String> names) {
        List<String> first =
                names.stream().limit(MAX_NAMES).map(MessageText::oneLine).collect(Collectors.toList());
        String rest = names.size() > MAX_NAMES ? " and " + (names.size() - MAX_NAMES) + " more" : "";
        return String.join(", ", first) + rest;
    }
}
