package faultline.floorplan;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads plain and quoted scalars of YAML. */
final class MapYamlScalar {

    private static final String ESCAPES = "0abtnvfre \"/\\N_LP";
    private static final String ESCAPED = "\0\u0007\b\t\n\u000B\f\r\u001B \"/\\\u0085\u00A0\u2028\u2029";

    /** Tags such as {@code !!float}, and anchors. */
    private static final Pattern PROPERTIES = Pattern.compile("(?:[!&]\\S*+\\s++){1,2}+");

    /** The mark before a text in lines. */
    private static final Pattern BLOCK = Pattern.compile("^[|>][-+0-9]{0,2}+[ \t]*+\n");

    private MapYamlScalar() {}

    /**
     * Returns the text of a scalar. Text in double quotes with an escape that YAML does not have, such as a path of
     * Windows, is returned as it is.
     */
    static String read(String scalar) {
        Matcher properties = PROPERTIES.matcher(scalar);
        String text = properties.lookingAt() ? scalar.substring(properties.end()) : scalar;
        text = text.indexOf('\n') < 0 ? text : fold(BLOCK.matcher(text).replaceFirst(""));
        if (text.length() < 2 || text.charAt(0) != text.charAt(text.length() - 1)) {
            return text;
        }
        String inner = text.substring(1, text.length() - 1);
        return switch (text.charAt(0)) {
            case '\'' -> inner.replace("''", "'");
            case '"' -> unescape(inner);
            default -> text;
        };
    }

    /** Returns a value without the tags and anchors before it. */
    static String withoutProperties(String value) {
        String text = value + ' ';
        Matcher properties = PROPERTIES.matcher(text);
        return properties.lookingAt() ? text.substring(properties.end()).strip() : value;
    }

    /** Joins lines with single blanks, or without one if a backslash in double quotes ends the line. */
    private static String fold(String text) {
        StringBuilder joined = new StringBuilder();
        String last = "";
        for (String line : text.split("\n")) {
            String part = line.strip();
            if (part.isEmpty()) {
                continue;
            }
            if (text.startsWith("\"") && endsInEscape(last)) {
                joined.setLength(joined.length() - 1);
            } else if (!joined.isEmpty()) {
                joined.append(' ');
            }
            joined.append(part);
            last = part;
        }
        return joined.toString();
    }

    /** Returns whether an odd number of backslashes, of which two are one escape, ends a text. */
    private static boolean endsInEscape(String text) {
        int i = text.length();
        while (i > 0 && text.charAt(i - 1) == '\\') {
            i--;
        }
        return (text.length() - i) % 2 == 1;
    }

    /**
     * Returns the index of the quotation mark that closes a quoted text from an index on, or the length of the text.
     */
    static int closing(CharSequence text, char quote, int from) {
        int i = from;
        while (i < text.length()) {
            char c = text.charAt(i);
            boolean doubled = quote == '\'' && c == quote && i + 1 < text.length() && text.charAt(i + 1) == quote;
            boolean escape = quote == '"' && c == '\\';
            if (c == quote && !doubled) {
                return i;
            }
            i += doubled || escape ? 2 : 1;
        }
        return text.length();
    }

    private static String unescape(String text) {
        StringBuilder unescaped = new StringBuilder();
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c != '\\') {
                unescaped.append(c);
                continue;
            }
            char kind = i + 1 < text.length() ? text.charAt(i + 1) : '?';
            int digits = kind == 'x' ? 2 : kind == 'u' ? 4 : kind == 'U' ? 8 : 0;
            int character = digits == 0 ? escaped(kind) : parseHex(text, i + 2, digits);
            if (character < 0) {
                return text;
            }
            unescaped.appendCodePoint(character);
            i += 1 + digits;
        }
        return unescaped.toString();
    }

    private static int escaped(char kind) {
        int index = ESCAPES.indexOf(kind);
        return index < 0 ? -1 : ESCAPED.charAt(index);
    }

    /** Returns the character with a code in hexadecimal digits, or -1 if it is none. */
    private static int parseHex(String text, int from, int digits) {
        String code = text.substring(Math.min(from, text.length()), Math.min(from + digits, text.length()));
        if (!code.matches("[0-9A-Fa-f]{" + digits + "}")) {
            return -1;
        }
        long character = Long.parseLong(code, 16);
        return character <= Character.MAX_CODE_POINT ? (int) character : -1;
    }
}
