package faultline.app;

import java.nio.file.Files;
import java.nio.file.Path;

/** The process that has started this one. */
final class StartingProcess {

    /** A file as standard output, which can be read later. */
    private static final Path OUTPUT = Path.of("/dev/stdout");

    /** Null if it is not known. */
    private final ProcessHandle handle;

    private StartingProcess(ProcessHandle handle) {
        this.handle = handle;
    }

    /** Returns the present parent of this process. */
    static StartingProcess current() {
        return new StartingProcess(parent());
    }

    private static ProcessHandle parent() {
        return ProcessHandle.current().parent().orElse(null);
    }

    /** Returns whether that process has ended, so that nobody reads standard output, unless that is a file. */
    boolean isGone() {
        // On Linux, the children of a process that has ended get another parent, also while it is a zombie.
        return handle != null && !(handle.isAlive() && handle.equals(parent())) && !Files.isRegularFile(OUTPUT);
    }
}
