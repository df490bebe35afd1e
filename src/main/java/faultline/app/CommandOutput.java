package faultline.app;

import java.io.PrintStream;
import java.util.List;

/**
 * Where a command tells what it does.
 *
 * @param out for what was asked for
 * @param err for what went wrong
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

    /** Whether all that was told has arrived; not so where a pipe was closed or a disk is full. */
    boolean isWritten() {
        return !out.checkError();
    }
}
