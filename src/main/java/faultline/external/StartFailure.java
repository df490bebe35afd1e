package faultline.external;

import faultline.io.ShellText;
import java.io.File;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Says in plain words why a program cannot be started. */
final class StartFailure {

    /**
     * The end of the JDK's messages up to version 24, "error=2, No such file", and after, "error: 2 (No such file)".
     */
    private static final Pattern ERROR = Pattern.compile("error(?:=|: )(\\d+)(?:, | \\()(.+?)\\)?$");

    private static final String MISSING = "2";
    private static final String NOT_PERMITTED = "13";
    /** The error of Windows for a file that is no program, such as a script. */
    private static final String NO_PROGRAM = "193";

    private static final Pattern PYTHON = Pattern.compile("py|python[\\d.]*");

    private StartFailure() {}

    /**
     * {@return the reason, as the end of a sentence}
     *
     * @param program the program, as it was given
     * @param message the message of the JDK
     */
    static String describe(String program, String message) {
        Matcher error = ERROR.matcher(message);
        if (!error.find()) {
            return message;
        }
        return switch (error.group(1)) {
            case MISSING -> missing(program) + pythonHint(program);
            case NOT_PERMITTED -> "the file is not executable" + pythonHint(program);
            case NO_PROGRAM -> "the file is not a program" + pythonHint(program);
            default -> error.group(2);
        };
    }

    /** A name without a folder is searched for in the folders of programs, which do not include the current one. */
    private static String missing(String program) {
        return new File(program).getParent() != null && new File(program).exists()
                ? "the interpreter that its first line names does not exist"
                : "there is no such program";
    }

    private static String pythonHint(String program) {
        String python = PythonCommand.text();
        if (PYTHON.matcher(program).matches() && !program.equals(python)) {
            return "; Python is usually started by \"" + python + "\"";
        }
        return program.endsWith(".py") && new File(program).exists()
                ? "; a program in Python is started by \"" + python + " " + ShellText.quoted(program) + "\""
                : "";
    }
}
