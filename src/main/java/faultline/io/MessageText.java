package faultline.io;

import java.util.Locale;
import java.util.regex.Pattern;

/** Prepares a user's text for messages. */
public final class MessageText {

    private static final int MAX_EXCERPT_LENGTH = 60;

    /** The beginning of a formula, or of a text with an apostrophe before it. */
    private static final Pattern FORMULA = Pattern.compile("'*+[=+@-]");

    /** The control characters, which no id has. Marks of the writing direction may be in ids and stay in tables. */
    private static final Pattern CONTROLS = Pattern.compile("[\\x00-\\x1F\\x7F-\\x9F]");

    private MessageText() {}

    /**
     * {@return a text in double quotes, on one line, and shortened if it is long}
     *
     * @param text the text
     */
    public static String quoted(String text) {
        return '"' + excerpt(text) + '"';
    }

    /**
     * {@return a text on one line, shortened if it is long}
     *
     * @param text the text
     */
    public static String excerpt(String text) {
        return oneLine(shortened(text, MAX_EXCERPT_LENGTH));
    }

    /**
     * {@return a text, or its start and three dots if it is long}
     *
     * @param text the text
     * @param length the greatest length of the start, in {@code char} values, positive
     */
    public static String shortened(String text, int length) {
        return text.length() > length ? start(text, length) + "..." : text;
    }

    /**
     * {@return the start of a text, without the first half of a character whose second half is cut off}
     *
     * @param text the text
     * @param length the greatest length of the start, in {@code char} values, positive
     */
    public static String start(String text, int length) {
        if (text.length() <= length) {
            return text;
        }
        return text.substring(0, Character.isHighSurrogate(text.charAt(length - 1)) ? length - 1 : length);
    }

    /**
     * {@return the name that something gives itself, as it is shown: on one line, with single blanks, and shortened if
     * it is long; empty if nothing visible is left}
     *
     * @param given the name as it was given
     */
    public static String name(String given) {
        return excerpt(oneLine(given).replaceAll("\\s+", " ").strip());
    }

    /**
     * {@return a text with a blank instead of every character that could change how the rest is shown: control
     * characters, line separators and the controls of bidirectional text}
     *
     * @param text the text
     */
    public static String oneLine(String text) {
        return text.codePoints()
                .map(c -> isControl(c) ? ' ' : c)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
    }

    static boolean isControl(int c) {
        return Character.isISOControl(c)
                || c == 0x2028
                || c == 0x2029
                || c == 0x061C
                || c == 0x200E
                || c == 0x200F
                || c >= 0x202A && c <= 0x202E
                || c >= 0x2066 && c <= 0x2069
                || c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE;
    }

    /**
     * {@return a text as a cell of a table, with an apostrophe before a sign at which a spreadsheet would take it for a
     * formula} Numbers stay as they are.
     *
     * @param text the text
     */
    public static String cell(String text) {
        return FORMULA.matcher(text).lookingAt() && DecimalText.parse(text).isEmpty() ? "'" + text : text;
    }

    /**
     * {@return the text that {@link #cell} has made a cell of}
     *
     * @param cell the cell
     */
    public static String textOfCell(String cell) {
        return cell.startsWith("'") && FORMULA.matcher(cell).lookingAt() ? cell.substring(1) : cell;
    }

    /**
     * {@return a text as a cell of a file of comma-separated values (RFC 4180)} It is put in quotes if it needs them,
     * its control characters become blanks, and a spreadsheet does not take it for a formula.
     *
     * @param text the text
     */
    public static String csvCell(String text) {
        String cell = cell(text);
        return isPlain(cell)
                ? cell
                : '"' + CONTROLS.matcher(cell).replaceAll(" ").replace("\"", "\"\"") + '"';
    }

    /** Returns whether a cell needs no quotes. */
    private static boolean isPlain(String cell) {
        for (int i = 0; i < cell.length(); i++) {
            char c = cell.charAt(i);
            if (c == ',' || c == '"' || Character.isISOControl(c)) {
                return false;
            }
        }
        return true;
    }

    /**
     * {@return the name of an enum constant in camel case, such as {@code tooDeep} for {@code TOO_DEEP}}
     *
     * @param constant the name of the constant
     */
    public static String camelCase(String constant) {
        return Pattern.compile("_(.)")
                .matcher(constant.toLowerCase(Locale.ROOT))
                .replaceAll(match -> match.group(1).toUpperCase(Locale.ROOT));
    }
}
