package faultline.io;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;

/**
 * A new file with a random name, which becomes another file or is deleted, at the latest when the process ends. Until
 * then only its owner may read it. The files of a killed process are deleted by the next process that writes to the
 * folder; a lock shows which files are still being written.
 */
final class TemporaryFile {

    private static final String PREFIX = ".faultline-";
    private static final String SUFFIX = ".tmp";
    private static final Set<PosixFilePermission> PRIVATE = PosixFilePermissions.fromString("rw-------");
    private static final Set<PosixFilePermission> PUBLIC = PosixFilePermissions.fromString("rw-rw-rw-");

    /** Deletes what is unfinished when the process is ended by a signal. */
    private static final class UnfinishedFiles {

        private static final Set<Path> FILES = ConcurrentHashMap.newKeySet();
        /** Held while files are created, moved into place or deleted. */
        private static final ReentrantLock LOCK = new ReentrantLock();
        /** Whether the process is ending, so that a new file would remain. */
        private static volatile boolean ended;

        static {
            ended = !ShutdownHooks.add(new Thread(UnfinishedFiles::deleteAll, "delete temporary files"));
        }

        /** Creates a file, unless the process is ending. No file is created while all are deleted. */
        private static TemporaryFile create(Path target, boolean secret) throws IOException {
            LOCK.lock();
            try {
                if (ended) {
                    throw new FileSystemException(target.toString(), null, "the program is ending");
                }
                return TemporaryFile.createRegistered(target, secret);
            } finally {
                LOCK.unlock();
            }
        }

        private static void keepAlive(Moves moves) throws IOException {
            LOCK.lock();
            try {
                moves.make();
            } finally {
                LOCK.unlock();
            }
        }

        private static void deleteAll() {
            try {
                if (!LOCK.tryLock(MAX_SECONDS_OF_MOVES, TimeUnit.SECONDS)) {
                    // The file system does not answer, so nothing could be deleted.
                    return;
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return;
            }
            ended = true;
            for (Path file : FILES) {
                delete(file);
            }
            LOCK.unlock();
        }

        /** Deletes a file, or a folder, in which other threads may still make files. */
        private static void delete(Path file) {
            for (int i = 0; i < MAX_DELETIONS && Files.exists(file, LinkOption.NOFOLLOW_LINKS); i++) {
                try {
                    TemporaryFolder.deleteTree(file);
                } catch (IOException e) {
                    // The process is ending, so the failure cannot be reported.
                }
            }
        }
    }

    /** Moves several files into place. */
    interface Moves {
        void make() throws IOException;
    }

    /** The time for which the end of the process waits for files that are moved into place, seconds. */
    private static final int MAX_SECONDS_OF_MOVES = 30;

    /** How often it is tried to delete something when the process ends. */
    private static final int MAX_DELETIONS = 10;

    private static final int MAX_MILLIS_WITHOUT_LOCK = 10_000;

    /** The folders that this process has already freed from abandoned files. */
    private static final Set<Path> SEARCHED_FOLDERS = ConcurrentHashMap.newKeySet();

    private final Path path;
    private final Set<PosixFilePermission> permissions;
    /** Null until the file is opened. */
    private FileChannel channel;

    private TemporaryFile(Path path, Set<PosixFilePermission> permissions) {
        this.path = path;
        this.permissions = permissions;
    }

    /**
     * Creates an empty file beside the target that it may become, which need not exist. It never opens a file or link
     * that exists. If it is secret, it stays one that only its owner may read, whatever it replaces.
     */
    static TemporaryFile create(Path target, boolean secret) throws IOException {
        return UnfinishedFiles.create(target, secret);
    }

    /** Lets a folder be deleted, with everything in it, at the latest when the process ends. */
    static void deleteAtExit(Path folder) {
        UnfinishedFiles.FILES.add(folder);
    }

    /** Does not let a file or folder be deleted when the process ends. */
    static void forget(Path path) {
        UnfinishedFiles.FILES.remove(path);
    }

    /** Returns whether a folder has temporary files, and no process has locked one of them. */
    static boolean hasAbandoned(Path folder, long now) throws IOException {
        boolean found = false;
        try (DirectoryStream<Path> files = list(folder)) {
            for (Path file : files) {
                if (UnfinishedFiles.FILES.contains(file) || !isAbandoned(file, now)) {
                    return false;
                }
                found = true;
            }
        }
        return found;
    }

    /** Deletes what this process has not finished; no other file is created after this. */
    static void deleteUnfinished() {
        UnfinishedFiles.deleteAll();
    }

    /** Returns whether the process is ending, so that all temporary files are deleted and no other is created. */
    static boolean isProgramEnding() {
        return UnfinishedFiles.ended;
    }

    /**
     * Moves files into place. If a signal arrives meanwhile, the process ends after the last move; if it is ending
     * already, the files no longer exist and the first move fails.
     */
    static void keepAliveDuring(Moves moves) throws IOException {
        UnfinishedFiles.keepAlive(moves);
    }

    private static TemporaryFile createRegistered(Path target, boolean secret) throws IOException {
        Path folder = target.getParent();
        if (!target.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            return register(new TemporaryFile(createFile(folder), Set.of()));
        }
        if (secret || Files.exists(target)) {
            Path path = createFile(folder, PosixFilePermissions.asFileAttribute(PRIVATE));
            return register(new TemporaryFile(path, secret ? PRIVATE : Files.getPosixFilePermissions(target)));
        }
        Path path = createFile(folder, PosixFilePermissions.asFileAttribute(PUBLIC));
        TemporaryFile created = register(new TemporaryFile(path, Files.getPosixFilePermissions(path)));
        FilePermissions.setIfPossible(path, PRIVATE);
        return created;
    }

    /** Returns a random name of a temporary file or folder. */
    static String newName() {
        return PREFIX + Long.toUnsignedString(new SplittableRandom().nextLong()) + SUFFIX;
    }

    /**
     * Creates a file with a random name that no file or link has. Unlike {@link Files#createTempFile}, this loads no
     * security provider, which takes a twentieth of the time of a short run.
     */
    private static Path createFile(Path folder, FileAttribute<?>... attributes) throws IOException {
        while (true) {
            try {
                return Files.createFile(folder.resolve(newName()), attributes);
            } catch (FileAlreadyExistsException e) {
                // Another name will be free.
            }
        }
    }

    /** Deletes the files of processes that were killed, as far as that is possible. */
    private static void deleteAbandoned(Path folder, long now) {
        if (!SEARCHED_FOLDERS.add(folder)) {
            return;
        }
        try (DirectoryStream<Path> files = list(folder)) {
            files.forEach(file -> deleteIfAbandoned(file, now));
        } catch (IOException | DirectoryIteratorException e) {
            // The files may remain; they have no effect.
        }
    }

    private static void deleteIfAbandoned(Path file, long now) {
        try {
            if (!UnfinishedFiles.FILES.contains(file) && isAbandoned(file, now)) {
                Files.deleteIfExists(file);
            }
        } catch (IOException e) {
            // The file may belong to another user. It has no effect.
        }
    }

    private static DirectoryStream<Path> list(Path folder) throws IOException {
        return Files.newDirectoryStream(folder, TemporaryFile::isTemporary);
    }

    private static boolean isTemporary(Path file) {
        String name = file.getFileName().toString();
        return name.startsWith(PREFIX) && name.endsWith(SUFFIX);
    }

    /** Deletes the temporary files in a folder that no process has locked, whatever their age, as far as possible. */
    static void deleteUnlocked(Path folder) throws IOException {
        // The paths of the files of this process have no links.
        try (DirectoryStream<Path> files = list(folder.toRealPath())) {
            files.forEach(file -> deleteIfAbandoned(file, Long.MAX_VALUE));
        } catch (DirectoryIteratorException e) {
            throw e.getCause();
        }
    }

    /**
     * Returns whether no process has locked a file, except for one that has just been created. Anything else of that
     * name is not opened: a pipe would block, and the locks of this process on the file of a link would end.
     */
    private static boolean isAbandoned(Path file, long now) throws IOException {
        if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                || Files.getLastModifiedTime(file).toMillis() > now - MAX_MILLIS_WITHOUT_LOCK) {
            return false;
        }
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
                FileLock free = channel.tryLock()) {
            return free != null;
        } catch (OverlappingFileLockException e) {
            return false;
        }
    }

    private static TemporaryFile register(TemporaryFile file) throws IOException {
        UnfinishedFiles.FILES.add(file.path);
        deleteAbandoned(
                file.path.getParent(), Files.getLastModifiedTime(file.path).toMillis());
        return file;
    }

    Path path() {
        return path;
    }

    /** Opens the file, and locks it where the system can do that. */
    FileChannel open() throws IOException {
        channel = FileChannel.open(path, StandardOpenOption.WRITE);
        try {
            channel.tryLock();
        } catch (IOException e) {
            // Without a lock, another process may treat the file as abandoned if nothing is written for some time.
        }
        return channel;
    }

    /** Gives the file the permissions of the target, or those of any new file if there is no target. */
    void applyPermissions() {
        if (!permissions.isEmpty()) {
            FilePermissions.setIfPossible(path, permissions);
        }
    }

    /** Forces the content to the disk. The lock remains, which a second channel would end when it is closed. */
    void force() throws IOException {
        channel.force(true);
    }

    /** Forces the names in a folder to the disk, where the system can do that. */
    static void forceFolder(Path folder) {
        try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException e) {
            // Not every system opens folders; the move itself has succeeded.
        }
    }

    /** Keeps the file, because it has become another one. */
    void forget() {
        forget(path);
    }

    void delete() throws IOException {
        forget();
        Files.deleteIfExists(path);
    }
}
