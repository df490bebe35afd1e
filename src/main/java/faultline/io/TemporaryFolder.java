package faultline.io;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;

/**
 * A new folder in the system's folder for temporary files. It is deleted at the latest when the process ends. The
 * folder of a process that was killed is deleted when the same user's next one is created; a lock shows which are in
 * use.
 */
public final class TemporaryFolder {

    private final Path path;
    private final TemporaryFile lock;
    /** Holds the lock. */
    private final FileChannel channel;

    private TemporaryFolder(Path path, TemporaryFile lock, FileChannel channel) {
        this.path = path;
        this.lock = lock;
        this.channel = channel;
    }

    /**
     * {@return a new folder}
     *
     * @param prefix the beginning of its name, which no other program uses
     * @throws IOException if it cannot be created
     */
    public static TemporaryFolder create(String prefix) throws IOException {
        Path path = Files.createTempDirectory(prefix);
        TemporaryFile.deleteAtExit(path);
        try {
            TemporaryFile lock = TemporaryFile.create(path.resolve("lock"), false);
            TemporaryFolder created = new TemporaryFolder(path, lock, lock.open());
            deleteAbandoned(path, prefix, Files.getLastModifiedTime(lock.path()).toMillis());
            return created;
        } catch (IOException e) {
            // The disk is full, or the process is ending.
            deleteTree(path);
            throw e;
        }
    }

    /** {@return its place} */
    public Path path() {
        return path;
    }

    /**
     * Deletes the folder and everything in it.
     *
     * @throws IOException if something in it cannot be deleted
     */
    public void delete() throws IOException {
        channel.close();
        lock.delete();
        deleteTree(path);
        TemporaryFile.forget(path);
    }

    /**
     * Deletes a file, or a folder and everything in it; links are not followed.
     *
     * @param top the file or folder, which need not exist
     * @throws IOException if something cannot be deleted
     */
    public static void deleteTree(Path top) throws IOException {
        if (Files.exists(top, LinkOption.NOFOLLOW_LINKS)) {
            try (Stream<Path> files = Files.walk(top)) {
                files.sorted(Comparator.reverseOrder()).forEach(TemporaryFolder::deleteFile);
            } catch (UncheckedIOException e) {
                throw e.getCause();
            }
        }
    }

    private static void deleteFile(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Deletes the folders of processes that were killed, as far as that is possible. */
    private static void deleteAbandoned(Path own, String prefix, long now) {
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(own.getParent(), prefix + "*")) {
            for (Path folder : folders) {
                if (!folder.equals(own)) {
                    deleteIfAbandoned(folder, own, now);
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            // The folders may remain; they have no effect.
        }
    }

    private static void deleteIfAbandoned(Path folder, Path own, long now) {
        try {
            if (Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)
                    && Files.getOwner(folder, LinkOption.NOFOLLOW_LINKS).equals(Files.getOwner(own))
                    && TemporaryFile.hasAbandoned(folder, now)) {
                deleteTree(folder);
            }
        } catch (IOException | DirectoryIteratorException e) {
            // The folder may remain; it has no effect.
        }
    }
}
