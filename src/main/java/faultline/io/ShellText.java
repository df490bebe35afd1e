package faultline.io;

import java.io.File;

/** Quotes words of commands that a user may paste into a shell, on Windows into its command prompt. */
public final class ShellText {

    private ShellText() {}

    /**
     * {@return a word as it is if the shell takes it so, or in quotes}
     *
     * @param word one argument of a command
     */
    public static String quoted(String word) {
        return File.separatorChar == '\\' ? quotedForWindows(word) : quotedForUnix(word);
    }

    static String quotedForUnix(String word) {
        if (word.matches("[\\w./:=@%+-]+")) {
            return word;
        }
        boolean plain = word.chars().noneMatch(c -> "\"$`\\!".indexOf(c) >= 0);
        return plain ? '"' + word + '"' : "'" + word.replace("'", "'\\''") + "'";
    }

    /** A backslash is an ordinary character there, except before a double quote. */
    static String quotedForWindows(String word) {
        if (word.matches("[\\w./\\\\:=@+-]+")) {
            return word;
        }
        String inner = word.replaceAll("(\\\\*)\"", "$1$1\\\\\"").replaceAll("(\\\\+)$", "$1$1");
        return '"' + inner + '"';
    }
}
