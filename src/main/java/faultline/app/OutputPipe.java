package faultline.app;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The pipe that is the standard output of this process. It is known on Linux only. */
final class OutputPipe {

    private OutputPipe() {}

    /**
     * Returns the other processes that have the pipe open for reading. Those of other users and of other containers are
     * not seen.
     */
    static Set<ProcessHandle> readers() {
        String own = target(Path.of("/proc/self/fd/1"));
        return own.startsWith("pipe:")
                ? ProcessHandle.allProcesses()
                        .filter(process -> !process.equals(ProcessHandle.current()))
                        .filter(process -> reads(process, own))
                        .collect(Collectors.toSet())
                : Set.of();
    }

    private static boolean reads(ProcessHandle process, String pipe) {
        try (Stream<Path> files = Files.list(Path.of("/proc", Long.toString(process.pid()), "fd"))) {
            return files.anyMatch(file -> target(file).equals(pipe) && isOpenForReading(file));
        } catch (IOException | UncheckedIOException endedOrOfAnotherUser) {
            return false;
        }
    }

    /** Returns what the link of an open file leads to, an empty string if the file is not open. */
    private static String target(Path link) {
        try {
            return Files.readSymbolicLink(link).toString();
        } catch (IOException notOpen) {
            return "";
        }
    }

    private static boolean isOpenForReading(Path link) {
        try {
            return Files.getPosixFilePermissions(link, LinkOption.NOFOLLOW_LINKS)
                    .contains(PosixFilePermission.OWNER_READ);
        } catch (IOException notOpen) {
            return false;
        }
    }
}
