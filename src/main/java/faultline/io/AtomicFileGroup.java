package faultline.io;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The files that one command writes, which take their places together. If the group is closed without a commit, nothing
 * changes. Several threads may create files at the same time.
 */
public final class AtomicFileGroup implements AutoCloseable {

    private final List<AtomicFile> files = new ArrayList<>();
    private final List<AtomicFile> discarded = new ArrayList<>();
    private boolean closed;

    /** Creates a group without files. */
    public AtomicFileGroup() {}

    /**
     * Opens a file of this group for writing.
     *
     * @param file the file to create or replace
     * @return the open file, which this group commits and closes
     * @throws IOException if the file cannot be written, or is the same as another of this group through a link, in one
     *     sentence
     * @throws IllegalStateException if the group has been closed
     */
    public synchronized AtomicFile create(Path file) throws IOException {
        if (closed) {
            throw new IllegalStateException("the group is closed");
        }
        AtomicFile created = AtomicFile.create(file);
        if (files.stream().anyMatch(created::replacesSameFile)) {
            created.close();
            throw new MessageException(MessageText.oneLine(file.toString()), WriteProblem.OTHER_OUTPUT.with(), null);
        }
        files.add(created);
        return created;
    }

    /**
     * Writes a file of this group.
     *
     * @param file the file to create or replace
     * @param bytes the content
     * @throws IOException if the file cannot be written, in one sentence
     * @throws IllegalStateException if the group has been closed
     */
    public void write(Path file, byte[] bytes) throws IOException {
        create(file).stream().write(bytes);
    }

    /**
     * Closes a file without a commit of its own. The commit of the group deletes the file that it would have replaced,
     * because that would seem to belong to the others.
     *
     * @param file a file that {@link #create} has returned
     * @throws IOException if the temporary file cannot be deleted
     */
    public synchronized void discard(AtomicFile file) throws IOException {
        files.remove(file);
        discarded.add(file);
        file.close();
    }

    /**
     * Moves all files of this group into place, as {@link AtomicFile#commitAll} does, and deletes those in the places
     * of discarded ones.
     *
     * @throws IOException if one cannot be moved or deleted
     */
    public synchronized void commit() throws IOException {
        AtomicFile.commitAll(files);
        for (AtomicFile file : discarded) {
            file.deleteTarget();
        }
    }

    /**
     * Closes all files, even if one of them cannot be deleted. No file can be created after this.
     *
     * @throws IOException if a temporary file cannot be deleted
     */
    @Override
    public synchronized void close() throws IOException {
        closed = true;
        IOException failure = null;
        for (AtomicFile file : files) {
            try {
                file.close();
            } catch (IOException e) {
                if (failure == null) {
                    failure = e;
                } else {
                    failure.addSuppressed(e);
                }
            }
        }
        if (failure != null) {
            throw failure;
        }
    }
}
