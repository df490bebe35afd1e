package faultline.app;

import java.io.PrintStream;
import java.util.List;

/**
 * Where a command tells what it does.
 *
 * @param out for what was asked for
 * @param err for what went wrong
 */
record Console(PrintStream out, PrintStream err) {

    void tell(String line) {
        out.println(line);
    }

    void tell(List<String> lines) {
        lines.forEach(this::tell);
    }

    void complain(String line) {
        err.println(line);
    }

    /** Whether all that was told has arrived; not so where a pipe was closed or a disk is full. */
    boolean arrived() {
        return !out.checkError();
    }
}
