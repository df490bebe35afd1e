package faultline.app;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;

/**
 * The program that waits for the answers of this process: those that read the pipe of standard output or, if they are
 * not known, the process that has started this one.
 */
final class ClientProcess {

    /** A file as standard output, which can be read later. */
    private static final Path OUTPUT = Path.of("/dev/stdout");

    /** The process that has started this one; null if it is not known. */
    private final ProcessHandle parent = parent();

    /** The readers at the first question; null before it, empty if they are not known. */
    private Set<ProcessHandle> readers;

    private static ProcessHandle parent() {
        return ProcessHandle.current().parent().orElse(null);
    }

    /** Returns whether the client has ended, so that nobody reads standard output. */
    boolean isGone() {
        if (readers == null) {
            readers = OutputPipe.readers();
        }
        if (readers.isEmpty()) {
            return isParentGone();
        }
        // To search takes long. A zombie counts as alive, but reads nothing.
        boolean hasEnded = readers.stream().noneMatch(ProcessHandle::isAlive) || isParentGone();
        return hasEnded && OutputPipe.readers().isEmpty();
    }

    private boolean isParentGone() {
        // On Linux, the children of a process that has ended get another parent, also while it is a zombie.
        return parent != null && !(parent.isAlive() && parent.equals(parent())) && !Files.isRegularFile(OUTPUT);
    }
}
