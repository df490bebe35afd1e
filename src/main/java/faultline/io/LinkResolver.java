package faultline.io;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileSystemLoopException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Finds out which file a path names if links and different spellings lead to it. Safe on any thread; the calls block.
 */
public final class LinkResolver {

    private static final int MAX_LINKS = 40;

    /** The bits of a mode that are the type of the file, and their value for a pipe (POSIX, sys/stat.h of Linux). */
    private static final int FILE_TYPE = 0xF000;

    private static final int PIPE = 0x1000;

    private LinkResolver() {}

    /**
     * {@return the first output that is the same file as an input or as an earlier output, through a link, a hard link
     * or another spelling} Devices and pipes are not compared.
     *
     * @param inputs files that are read
     * @param outputs files that are to be written, which need not exist
     */
    public static Optional<Path> findConflict(Collection<Path> inputs, Collection<Path> outputs) {
        if (outputs.isEmpty()) {
            return Optional.empty();
        }
        Set<Object> seen = new HashSet<>();
        for (Path input : inputs) {
            seen.add(identity(input));
        }
        for (Path output : outputs) {
            if (!seen.add(identity(output)) && !isDevice(output)) {
                return Optional.of(output);
            }
        }
        return Optional.empty();
    }

    /**
     * {@return the first output that is the same named pipe as an earlier one} A program that reads the pipe would get
     * both in one, and may end between them. A pipe that the process has inherited, such as {@code /dev/stdout}, stays
     * open, and is not meant.
     *
     * @param outputs files that are to be written, which need not exist
     */
    public static Optional<Path> findRepeatedPipe(Collection<Path> outputs) {
        Set<Object> seen = new HashSet<>();
        return outputs.stream()
                .filter(output -> isNamedPipe(output) && !seen.add(identity(output)))
                .findFirst();
    }

    private static boolean isNamedPipe(Path file) {
        try {
            return isDevice(file)
                    && file.getFileSystem().supportedFileAttributeViews().contains("unix")
                    && ((int) Files.getAttribute(file, "unix:mode") & FILE_TYPE) == PIPE
                    && !isInherited(file);
        } catch (IOException e) {
            return false;
        }
    }

    /** Returns an object that is equal for two paths if they name the same file. */
    private static Object identity(Path file) {
        try {
            if (Files.exists(file)) {
                Object key =
                        Files.readAttributes(file, BasicFileAttributes.class).fileKey();
                return key == null ? file.toRealPath() : key;
            }
            return resolve(file);
        } catch (IOException e) {
            return file.toAbsolutePath().normalize();
        }
    }

    /**
     * {@return the file that a path names, with links resolved} The file need not exist, nor the file that a link
     * points to.
     *
     * @param file the path
     * @throws IOException if the links form a loop
     */
    public static Path resolve(Path file) throws IOException {
        List<Path> chain = followLinks(file);
        Path last = chain.get(chain.size() - 1);
        if (Files.exists(last)) {
            return last.toRealPath();
        }
        Path parent = last.getParent();
        return parent != null && Files.exists(parent)
                ? parent.toRealPath().resolve(last.getFileName()).normalize()
                : last.normalize();
    }

    /** Returns a path, and each path that it and its successors point to if they are links. */
    private static List<Path> followLinks(Path file) throws IOException {
        List<Path> chain = new ArrayList<>();
        Path next = file.toAbsolutePath();
        chain.add(next);
        while (Files.isSymbolicLink(next)) {
            if (chain.size() > MAX_LINKS) {
                throw new FileSystemLoopException(file.toString());
            }
            next = next.resolveSibling(Files.readSymbolicLink(next));
            chain.add(next);
        }
        return chain;
    }

    /**
     * Refuses a device or a pipe, because a program with a window cannot wait for whoever reads it.
     *
     * @param file the file, which need not exist
     * @throws IOException if it is a device or a pipe, in one sentence
     */
    public static void refuseDevice(Path file) throws IOException {
        if (isDevice(file)) {
            throw new MessageException(MessageText.oneLine(file.toString()), WriteProblem.IS_DEVICE.with(), null);
        }
    }

    private static boolean isDevice(Path file) {
        return Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file);
    }

    /**
     * Returns whether a path names something that is written to directly: a device, a pipe, or a file that the process
     * has inherited, such as {@code /dev/stdout}.
     */
    static boolean isStream(Path file) throws IOException {
        return isDevice(file) || Files.isRegularFile(file) && isInherited(file);
    }

    private static boolean isInherited(Path file) throws IOException {
        for (Path link : followLinks(file)) {
            Path path = link.normalize();
            if (path.startsWith("/proc") || path.startsWith("/dev/fd")) {
                return true;
            }
        }
        return false;
    }

    /** Opens a stream; see {@link #isStream}. Its present content remains. */
    static OutputStream openStream(Path file) throws IOException {
        String own = "(/dev/fd/|/proc/(self|" + ProcessHandle.current().pid() + ")/fd/)";
        for (Path link : followLinks(file)) {
            String path = link.normalize().toString();
            if (path.matches(own + 1)) {
                return standardStream(FileDescriptor.out);
            }
            if (path.matches(own + 2)) {
                return standardStream(FileDescriptor.err);
            }
        }
        return new BufferedOutputStream(Files.newOutputStream(
                file, Files.isRegularFile(file) ? StandardOpenOption.APPEND : StandardOpenOption.WRITE));
    }

    /** Returns a stream that can be closed without closing the one of the process. */
    private static OutputStream standardStream(FileDescriptor descriptor) {
        return new BufferedOutputStream(new FileOutputStream(descriptor)) {
            @Override
            public void close() throws IOException {
                flush();
            }
        };
    }
}
