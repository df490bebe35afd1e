package faultline.io;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A new file with a random name, which becomes another file or is deleted, at the latest when the process ends. Until
 * then only its owner may read it.
 */
final class TemporaryFile {

    private static final String PREFIX = ".faultline-";
    private static final String SUFFIX = ".tmp";
    private static final Set<PosixFilePermission> PRIVATE = PosixFilePermissions.fromString("rw-------");
    private static final Set<PosixFilePermission> PUBLIC = PosixFilePermissions.fromString("rw-rw-rw-");

    /** Deletes what is unfinished when the process is ended by a signal. */
    private static final class Unfinished {

        private static final Set<Path> FILES = ConcurrentHashMap.newKeySet();

        static {
            Runtime.getRuntime().addShutdownHook(new Thread(Unfinished::deleteAll, "delete temporary files"));
        }

        private static void deleteAll() {
            for (Path file : FILES) {
                try {
                    Files.deleteIfExists(file);
                } catch (IOException e) {
                    // The process is ending; nobody could be informed.
                }
            }
        }
    }

    private final Path path;
    private final Set<PosixFilePermission> permissions;

    private TemporaryFile(Path path, Set<PosixFilePermission> permissions) {
        this.path = path;
        this.permissions = permissions;
    }

    /**
     * Creates an empty file beside a target. It never opens a file or link that exists.
     *
     * @param target the file that it may become, which need not exist
     */
    static TemporaryFile create(Path target) throws IOException {
        Path folder = target.getParent();
        if (!target.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            return register(new TemporaryFile(Files.createTempFile(folder, PREFIX, SUFFIX), Set.of()));
        }
        if (Files.exists(target)) {
            Path path = Files.createTempFile(folder, PREFIX, SUFFIX);
            return register(new TemporaryFile(path, Files.getPosixFilePermissions(target)));
        }
        Path path = Files.createTempFile(folder, PREFIX, SUFFIX, PosixFilePermissions.asFileAttribute(PUBLIC));
        TemporaryFile created = register(new TemporaryFile(path, Files.getPosixFilePermissions(path)));
        Files.setPosixFilePermissions(path, PRIVATE);
        return created;
    }

    private static TemporaryFile register(TemporaryFile file) {
        Unfinished.FILES.add(file.path);
        return file;
    }

    Path path() {
        return path;
    }

    /** Gives the file the permissions of the target, or those of any new file if there is no target. */
    void applyPermissions() throws IOException {
        if (!permissions.isEmpty()) {
            Files.setPosixFilePermissions(path, permissions);
        }
    }

    /** Forces the content to the disk. */
    void force() throws IOException {
        try (FileChannel channel = FileChannel.open(path, StandardOpenOption.WRITE)) {
            channel.force(true);
        }
    }

    /** Forces the names in a folder to the disk, where the system can do that. */
    static void forceFolder(Path folder) {
        try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException e) {
            // Not every system opens folders; the move itself has succeeded.
        }
    }

    /** Leaves the file alone, because it has become another one. */
    void forget() {
        Unfinished.FILES.remove(path);
    }

    /** Deletes the file. */
    void delete() throws IOException {
        forget();
        Files.deleteIfExists(path);
    }
}
