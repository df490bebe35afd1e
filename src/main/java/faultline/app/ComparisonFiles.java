package faultline.app;

import faultline.campaign.report.ControllerComparison;
import faultline.io.AtomicFile;
import faultline.io.AtomicFileGroup;
import faultline.io.MessageText;
import faultline.scenario.xml.XmlFile;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The files that {@code compare} writes: a page, a table, and a replay for each controller. All are opened before the
 * runs, so that one that cannot be written is reported at once, and moved into place after them. A page that is a
 * device or a pipe has no files beside it.
 */
final class ComparisonFiles implements AutoCloseable {

    private final Path page;
    private final Path table;
    private final List<Path> replays = new ArrayList<>();
    private final AtomicFileGroup group = new AtomicFileGroup();
    private final Map<Path, AtomicFile> opened = new HashMap<>();
    private final Set<Path> written = new HashSet<>();

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

    private List<Path> all() {
        List<Path> all = new ArrayList<>(List.of(page, table));
        all.addAll(replays);
        return all;
    }

    /** Throws an exception if a file would replace an input or another file. */
    void requireDistinct(List<Path> inputs) throws UsageException {
        Arguments.requireDistinct(inputs, all());
    }

    /** Opens all files. Throws an exception if one beside the page would replace a file of another kind. */
    void open() throws IOException {
        AtomicFile openedPage = group.create(page);
        opened.put(page, openedPage);
        if (!openedPage.isStream()) {
            requireOwn(table, isTable(table));
            opened.put(table, group.create(table));
            for (Path replay : replays) {
                requireOwn(replay, XmlFile.isRecordedScenario(replay));
                opened.put(replay, group.create(replay));
            }
        }
    }

    /** The user has named only the page, so a file beside it is replaced only if a comparison may have written it. */
    private static void requireOwn(Path file, boolean own) throws IOException {
        if (Files.isRegularFile(file) && !own) {
            throw new IOException(MessageText.oneLine(file.toString())
                    + ": compare would replace or delete this file, which no comparison has written;"
                    + " use another name in --out");
        }
    }

    private static boolean isTable(Path file) throws IOException {
        byte[] header = ControllerComparison.csvHeader().getBytes(StandardCharsets.UTF_8);
        if (!Files.isReadable(file) || !Files.isRegularFile(file)) {
            return false;
        }
        try (InputStream in = Files.newInputStream(file)) {
            return Arrays.equals(header, in.readNBytes(header.length));
        }
    }

    /** Returns whether the page, which has been opened, has files beside it. */
    boolean areBesidePage() {
        return opened.containsKey(table);
    }

    /** Writes one of the opened files. */
    void write(Path file, byte[] content) throws IOException {
        opened.get(file).stream().write(content);
        written.add(file);
    }

    /**
     * Moves the written files into place. A controller whose runs all broke, or whose run cannot be saved, has no
     * replay; one that an earlier comparison wrote for it is deleted, because it would seem to be of this one.
     */
    void commit() throws IOException {
        for (Path replay : replays) {
            if (opened.containsKey(replay) && !written.contains(replay)) {
                group.discard(opened.get(replay));
            }
        }
        group.commit();
    }

    @Override
    public void close() throws IOException {
        group.close();
    }
}
