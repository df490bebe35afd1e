package faultline.external;

import faultline.engine.RunProblem;
import faultline.io.Message;
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
    static Message describe(String program, String message) {
        Matcher error = ERROR.matcher(message);
        if (!error.find()) {
            return RunProblem.OTHER.with(message);
        }
        if (new File(program).isDirectory() && error.group(1).equals(NOT_PERMITTED)) {
            return ControllerProblem.FOLDER.with();
        }
        return switch (error.group(1)) {
            case MISSING -> withHint(missing(program), program);
            case NOT_PERMITTED -> withHint(ControllerProblem.NOT_EXECUTABLE, program);
            case NO_PROGRAM -> withHint(ControllerProblem.NOT_A_PROGRAM, program);
            default -> RunProblem.OTHER.with(error.group(2));
        };
    }

    /** A name without a folder is searched for in the folders of programs, which do not include the current one. */
    private static ControllerProblem missing(String program) {
        return new File(program).getParent() != null && new File(program).exists()
                ? ControllerProblem.NO_INTERPRETER
                : ControllerProblem.NO_PROGRAM;
    }

    private static Message withHint(ControllerProblem reason, String program) {
        String python = PythonCommand.text();
        if (PYTHON.matcher(program).matches() && !program.equals(python)) {
            return ControllerProblem.USUAL_PYTHON.with(reason.with(), python);
        }
        if (program.endsWith(".jar")) {
            return ControllerProblem.JAR.with(reason.with());
        }
        return program.endsWith(".py") && new File(program).exists()
                ? ControllerProblem.PYTHON_SCRIPT.with(reason.with(), python, ShellText.quoted(program))
                : reason.with();
    }
}
