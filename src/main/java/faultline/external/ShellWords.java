package faultline.external;

import java.util.ArrayList;
import java.util.List;

/**
 * Splits a command into words as a shell does: words are separated by blanks, and quotes and backslashes preserve
 * blanks.
 */
public final class ShellWords {

    private ShellWords() {}

    /**
     * {@return the words of a command; empty if there is none}
     *
     * @param command such as {@code python3 "my follower.py"}; a backslash outside quotes is an ordinary character
     *     unless a blank, a quote or a backslash follows, so that Windows paths need no quotes
     * @throws IllegalArgumentException if a quote is not closed
     */
    public static List<String> split(String command) {
        List<String> words = new ArrayList<>();
        StringBuilder word = new StringBuilder();
        boolean started = false;
        char quote = 0;
        for (int i = 0; i < command.length(); i++) {
            char c = command.charAt(i);
            if (isEscape(command, i, quote)) {
                word.append(command.charAt(++i));
                started = true;
            } else if (quote != 0 && c == quote) {
                quote = 0;
            } else if (quote != 0) {
                word.append(c);
            } else if (c == '"' || c == '\'') {
                quote = c;
                started = true;
            } else if (!Character.isWhitespace(c)) {
                word.append(c);
                started = true;
            } else if (started) {
                words.add(word.toString());
                word.setLength(0);
                started = false;
            }
        }
        if (quote != 0) {
            throw new IllegalArgumentException("a quote is not closed");
        }
        if (started) {
            words.add(word.toString());
        }
        return words;
    }

    /**
     * {@return a word in double quotes, from which {@link #split} makes the same word}
     *
     * @param word any text; a backslash in it is doubled only where it would escape the next character
     */
    public static String quoted(String word) {
        return '"' + word.replaceAll("\\\\(?=[\\\\\"]|$)|\"", "\\\\$0") + '"';
    }

    /** Returns whether a backslash escapes the next character. */
    private static boolean isEscape(String command, int index, char quote) {
        String special = quote == 0 ? " \"'\\" : quote == '"' ? "\"\\" : "";
        return command.charAt(index) == '\\'
                && index + 1 < command.length()
                && special.indexOf(command.charAt(index + 1)) >= 0;
    }
}
