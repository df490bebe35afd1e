package faultline.app;

import java.io.PrintStream;
import java.util.List;

/**
 * The output of a command.
 *
 * @param out receives results
 * @param err receives error messages
 */
record CommandOutput(PrintStream out, PrintStream err) {

    void println(String line) {
        out.println(line);
    }

    void println(List<String> lines) {
        lines.forEach(this::println);
    }

    void printError(String line) {
        err.println(line);
    }

    /** Flushes both streams and returns whether everything was written; false if a pipe is closed or a disk is full. */
    boolean isWritten() {
        return !out.checkError();
    }
}
