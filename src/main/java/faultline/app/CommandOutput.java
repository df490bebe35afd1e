package faultline.app;

import faultline.io.MessageText;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The output of a command: results and error messages. */
record CommandOutput(PrintStream out, PrintStream err) {

    /** The standard error of the process; that of controllers in Java replaces {@link System#err} later. */
    static final PrintStream STANDARD_ERROR = System.err;

    /** Prints a line; control characters in it, which may come from the name of a file, are replaced by blanks. */
    void println(String line) {
        out.println(MessageText.oneLine(line));
    }

    void println(List<String> lines) {
        lines.forEach(this::println);
    }

    /** Prints a JSON value as a line, in UTF-8 whatever the encoding of the output (RFC 8259, section 8.1). */
    void printJson(String json) {
        byte[] line = (MessageText.oneLine(json) + System.lineSeparator()).getBytes(StandardCharsets.UTF_8);
        out.write(line, 0, line.length);
    }

    /** Prints a line; control characters in it are replaced by blanks. */
    void printError(String line) {
        err.println(MessageText.oneLine(line));
    }

    /** Prints one line for each problem. */
    void printError(ScenarioException exception) {
        printNotes(exception.problems());
    }

    /** Prints one line for each thing that a user should know of a file. */
    void printNotes(List<Problem> notes) {
        notes.forEach(note -> printError(note.toString()));
    }

    /** Flushes the output and returns whether all of it was written; false if a pipe is closed or a disk is full. */
    boolean isWritten() {
        return !out.checkError();
    }
}
