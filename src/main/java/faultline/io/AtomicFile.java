package faultline.io;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * A file that exists completely or not at all: written under a random name in the same folder, forced to the disk, and
 * moved into place by {@link #commit()}. If it is closed without a commit, or is open when a signal ends the process,
 * nothing remains. A device or a pipe, such as {@code /dev/stdout}, is written directly.
 *
 * <p>While it is written, only its owner may read it; in its place it has the permissions of the file that it replaces.
 */
public final class AtomicFile implements AutoCloseable {

    /** Large, because long traces are written through it. */
    private static final int BUFFER = 1 << 16;

    private final Path target;
    private final TemporaryFile temporary;
    private final FailureReportingStream stream;
    private boolean committed;

    private AtomicFile(Path target, TemporaryFile temporary, FailureReportingStream stream) {
        this.target = target;
        this.temporary = temporary;
        this.stream = stream;
    }

    /**
     * Opens a file for writing. The target does not change before the commit.
     *
     * @param file the file to create or replace
     * @return the open file, which is to be committed and closed
     * @throws IOException if the file cannot be written, in one sentence
     */
    public static AtomicFile create(Path file) throws IOException {
        return create(file, false);
    }

    private static AtomicFile create(Path file, boolean secret) throws IOException {
        if (Files.isDirectory(file)) {
            throw new MessageException(MessageText.oneLine(file.toString()), WriteProblem.IS_FOLDER.with(), null);
        }
        try {
            if (LinkResolver.isStream(file)) {
                return new AtomicFile(file, null, new FailureReportingStream(file, LinkResolver.openStream(file)));
            }
            Path target = LinkResolver.resolve(file);
            if (exists(target) && !Files.isWritable(target)) {
                throw new MessageException(MessageText.oneLine(file.toString()), WriteProblem.READ_ONLY.with(), null);
            }
            TemporaryFile temporary = TemporaryFile.create(target, secret);
            FileChannel channel = temporary.open();
            OutputStream stream = new BufferedOutputStream(new ForcingOutputStream(channel), BUFFER);
            return new AtomicFile(target, temporary, new FailureReportingStream(file, stream));
        } catch (FileSystemException e) {
            WriteProblem reason =
                    TemporaryFile.isProgramEnding() ? WriteProblem.PROGRAM_ENDS : WriteProblem.ofCreation(file, e);
            throw new MessageException(MessageText.oneLine(file.toString()), reason.with(), e);
        }
    }

    /** {@return whether this is a device or a pipe, which is written directly} */
    public boolean isStream() {
        return temporary == null;
    }

    /** Returns whether the commits of this file and another one replace the same file. */
    boolean replacesSameFile(AtomicFile other) {
        return !isStream() && !other.isStream() && target.equals(other.target);
    }

    /**
     * Deletes the temporary files that killed processes have left in a folder, also those that a process may just have
     * left. Those that a process is writing, and those that cannot be deleted, stay.
     *
     * @param folder the folder
     * @throws IOException if the folder cannot be read
     */
    public static void deleteTemporaryFiles(Path folder) throws IOException {
        TemporaryFile.deleteUnlocked(folder);
    }

    /** Deletes the temporary files of this process, which is ending or about to be halted and writes no others. */
    public static void deleteUnfinished() {
        TemporaryFile.deleteUnfinished();
    }

    /**
     * Unlike {@link Files#exists}, throws an exception if such a file cannot exist, for example because its name is too
     * long.
     */
    private static boolean exists(Path file) throws IOException {
        try {
            Files.readAttributes(file, BasicFileAttributes.class);
            return true;
        } catch (NoSuchFileException e) {
            return false;
        }
    }

    /**
     * Writes a whole file; an existing one is replaced.
     *
     * @param file the file to create or replace
     * @param bytes the content
     * @throws IOException if the file cannot be written, in one sentence
     */
    public static void write(Path file, byte[] bytes) throws IOException {
        write(create(file), bytes);
    }

    /**
     * Writes a whole file that only its owner may read, where the file system can do that, even if it replaces one that
     * others may read.
     *
     * @param file the file to create or replace
     * @param bytes the content
     * @throws IOException if the file cannot be written, in one sentence
     */
    public static void writeSecret(Path file, byte[] bytes) throws IOException {
        write(create(file, true), bytes);
    }

    private static void write(AtomicFile file, byte[] bytes) throws IOException {
        try (AtomicFile out = file) {
            out.stream().write(bytes);
            out.commit();
        }
    }

    /** {@return the buffered stream for the content; the commit closes it} */
    public OutputStream stream() {
        return stream;
    }

    /**
     * Moves the written file into place.
     *
     * @throws IOException if it cannot be moved
     */
    public void commit() throws IOException {
        commitAll(List.of(this));
    }

    /**
     * Moves the written files of one command into place. Nothing is moved before all are on the disk, and a signal that
     * arrives after the first move ends the process after the last one. A file system that refuses a move, or a process
     * that is killed between these moves, leaves some files as they were.
     *
     * @param files the files, each at another place
     * @throws IOException if one cannot be moved
     */
    public static void commitAll(Collection<AtomicFile> files) throws IOException {
        for (AtomicFile file : files) {
            file.complete();
        }
        TemporaryFile.keepAliveDuring(() -> {
            for (AtomicFile file : files) {
                file.move();
            }
        });
        Set<Path> folders = new LinkedHashSet<>();
        files.stream().filter(file -> file.temporary != null).forEach(file -> folders.add(file.target.getParent()));
        folders.forEach(TemporaryFile::forceFolder);
    }

    /** Writes what is still in the buffer, and forces it to the disk. The file stays open and locked. */
    private void complete() throws IOException {
        stream.flush();
        if (temporary == null) {
            stream.close();
            committed = true;
            return;
        }
        try {
            temporary.force();
        } catch (IOException e) {
            throw problem(e);
        }
        temporary.applyPermissions();
    }

    private void move() throws IOException {
        if (temporary == null) {
            return;
        }
        stream.close();
        try {
            moveToTarget();
        } catch (IOException e) {
            throw problem(e);
        }
        committed = true;
        temporary.forget();
    }

    /** Deletes the file that this one would have replaced, if it exists. A device or a pipe stays. */
    void deleteTarget() throws IOException {
        if (temporary != null) {
            Files.deleteIfExists(target);
        }
    }

    private MessageException problem(IOException e) {
        return TemporaryFile.isProgramEnding() ? stream.problem(WriteProblem.PROGRAM_ENDS, e) : stream.problem(e);
    }

    private void moveToTarget() throws IOException {
        try {
            Files.move(temporary.path(), target, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(temporary.path(), target, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    @Override
    public void close() throws IOException {
        if (committed) {
            return;
        }
        stream.closeIgnoringErrors();
        if (temporary != null) {
            temporary.delete();
        }
    }
}
