package faultline.app;

import faultline.io.AtomicFile;
import faultline.io.MessageText;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The files that {@code compare} writes: a page, a table, and a replay for each controller. All are opened before the
 * runs, so that one that cannot be written is reported at once, and moved into place after them.
 */
final class ComparisonFiles implements AutoCloseable {

    private final Path page;
    private final Path table;
    private final List<Path> replays = new ArrayList<>();
    private final Map<Path, AtomicFile> files = new LinkedHashMap<>();
    private final Map<Path, AtomicFile> written = new LinkedHashMap<>();

    /**
     * Names the files.
     *
     * @param page the page, beside which the others are
     * @param controllers the number of controllers
     * @throws UsageException if the page cannot be a file
     */
    ComparisonFiles(Path page, int controllers) throws UsageException {
        if (page.getFileName() == null) {
            throw new UsageException(MessageText.quoted(page.toString()) + " is a folder; expected a file");
        }
        String name = page.getFileName().toString().replaceFirst("\\.html?$", "");
        this.page = page;
        this.table = page.resolveSibling(name + ".csv");
        for (int i = 1; i <= controllers; i++) {
            replays.add(page.resolveSibling(name + "-" + i + ".xml"));
        }
    }

    Path page() {
        return page;
    }

    Path table() {
        return table;
    }

    Path replay(int index) {
        return replays.get(index);
    }

    /** Throws an exception if a file would replace an input or another file. */
    void requireDistinct(List<Path> inputs) throws UsageException {
        List<Path> all = new ArrayList<>(List.of(page, table));
        all.addAll(replays);
        Arguments.requireDistinct(inputs, all);
    }

    /** Opens all files. */
    void open() throws IOException {
        List<Path> all = new ArrayList<>(List.of(page, table));
        all.addAll(replays);
        for (Path file : all) {
            files.put(file, AtomicFile.create(file));
        }
    }

    /** Writes one of the opened files. */
    void write(Path file, byte[] content) throws IOException {
        files.get(file).stream().write(content);
        written.put(file, files.get(file));
    }

    /**
     * Moves the written files into place. A replay that an earlier comparison wrote to one of the other files is
     * deleted, because it would seem to be of this one.
     */
    void commit() throws IOException {
        AtomicFile.commitAll(written.values());
        for (Path replay : replays) {
            if (!written.containsKey(replay) && Files.isRegularFile(replay)) {
                Files.delete(replay);
            }
        }
    }

    @Override
    public void close() throws IOException {
        for (AtomicFile file : files.values()) {
            file.close();
        }
    }
}
