package faultline.io;

/** Quotes words of commands that a user may paste into a shell. */
public final class ShellText {

    private ShellText() {}

    /**
     * {@return a word as it is if the shell takes it so, or in quotes}
     *
     * @param word one argument of a command
     */
    public static String quoted(String word) {
        if (word.matches("[\\w./:=@%+-]+")) {
            return word;
        }
        boolean plain = word.chars().noneMatch(c -> "\"$`\\!".indexOf(c) >= 0);
        return plain ? '"' + word + '"' : "'" + word.replace("'", "'\\''") + "'";
    }
}
