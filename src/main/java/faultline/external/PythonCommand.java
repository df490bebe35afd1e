package faultline.external;

import java.io.File;

/** The command that starts Python, for commands that are shown to users. */
public final class PythonCommand {

    private PythonCommand() {}

    /** {@return the name of the interpreter; on Windows {@code py}, because its installer provides no python3} */
    public static String text() {
        return text(File.separatorChar);
    }

    static String text(char separator) {
        return separator == '\\' ? "py" : "python3";
    }
}
