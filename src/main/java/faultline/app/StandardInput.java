package faultline.app;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** The standard input of this process. */
final class StandardInput {

    private static final Path LINK = Path.of("/proc/self/fd/0");

    private StandardInput() {}

    /**
     * Returns the standard input, or an empty stream if it is closed. On Linux, a file of the virtual machine then has
     * its number.
     */
    static InputStream stream() {
        return isClosed() ? InputStream.nullInputStream() : System.in;
    }

    private static boolean isClosed() {
        try {
            Path machine = Path.of(System.getProperty("java.home")).toRealPath();
            return Files.isSymbolicLink(LINK) && Files.readSymbolicLink(LINK).startsWith(machine);
        } catch (IOException unknown) {
            return false;
        }
    }
}
