package faultline.io;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A file that is there whole or not at all: written under another name in the same folder, and moved into place by
 * {@link #commit()}. One that is closed without that leaves no trace. A device such as {@code /dev/stdout} is written
 * directly.
 */
public final class AtomicFile implements AutoCloseable {

    /**
     * The same file may be written twice at once, as by two saves in quick succession: each has its own place until its
     * commit.
     */
    private static final AtomicLong SEQUENCE = new AtomicLong();

    private final Path target;
    private final Path temporaryFile;
    private final OutputStream stream;
    private boolean committed;

    private AtomicFile(Path target, Path written, OutputStream stream) {
        this.target = target;
        this.temporaryFile = written;
        this.stream = stream;
    }

    /**
     * Opens a file for writing; nothing is seen of it before the commit.
     *
     * @param file where it is to be
     * @return the open file
     * @throws IOException if it cannot be written there, in one sentence
     */
    public static AtomicFile create(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new MessageException(file.toString(), WriteProblem.IS_FOLDER.with(), null);
        }
        try {
            Path target = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
            if (Files.exists(target) && !Files.isRegularFile(target)) {
                return new AtomicFile(target, target, Files.newOutputStream(target));
            }
            if (Files.exists(target) && !Files.isWritable(target)) {
                throw new MessageException(file.toString(), WriteProblem.READ_ONLY.with(), null);
            }
            return createTemporary(target);
        } catch (java.nio.file.FileSystemException e) {
            throw new MessageException(file.toString(), WriteProblem.CANNOT_WRITE.with(), e);
        }
    }

    private static AtomicFile createTemporary(Path target) throws IOException {
        Path written = target.resolveSibling("." + target.getFileName() + "."
                + ProcessHandle.current().pid() + "-" + SEQUENCE.incrementAndGet() + ".tmp");
        OutputStream stream = Files.newOutputStream(
                written, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE);
        return new AtomicFile(target, written, new BufferedOutputStream(stream));
    }

    /**
     * Where the content goes.
     *
     * @return buffered; closed by the commit
     */
    public OutputStream stream() {
        return stream;
    }

    /**
     * Puts the written file in its place.
     *
     * @throws IOException if it cannot be
     */
    public void commit() throws IOException {
        stream.close();
        if (!temporaryFile.equals(target)) {
            moveToTarget();
        }
        committed = true;
    }

    private void moveToTarget() throws IOException {
        try {
            Files.move(temporaryFile, target, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(temporaryFile, target, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    @Override
    public void close() throws IOException {
        if (!committed && !temporaryFile.equals(target)) {
            stream.close();
            Files.deleteIfExists(temporaryFile);
        }
    }
}
