package faultline.external;

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
        if (error.group(1).equals(MISSING)) {
            return new File(program).exists()
                    ? "the interpreter that its first line names does not exist"
                    : "there is no such program";
        }
        return error.group(1).equals(NOT_PERMITTED) ? "the file is not executable" : error.group(2);
    }
}
