package faultline.gui.window;

import faultline.gui.window.WindowMemory.Store;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The files that were open last, newest first. */
final class RecentFiles {

    private static final String KEY = "recent";
    private static final int MOST = 8;
    /** As long as a text in the preferences may be. */
    private static final int MOST_LETTERS = 8192;

    private final Store store;

    RecentFiles(Store store) {
        this.store = store;
    }

    /** The files, newest first; whether they are still there is found out when one is opened. */
    List<Path> files() {
        return store.get(KEY).lines().flatMap(RecentFiles::path).toList();
    }

    private static Stream<Path> path(String line) {
        try {
            return line.isBlank() ? Stream.empty() : Stream.of(Path.of(line));
        } catch (InvalidPathException damaged) {
            return Stream.empty();
        }
    }

    void add(Path file) {
        Path newest = file.toAbsolutePath().normalize();
        keep(Stream.concat(Stream.of(newest), files().stream().filter(other -> !other.equals(newest))).limit(MOST).toList());
    }

    void remove(Path file) {
        Path gone = file.toAbsolutePath().normalize();
        keep(files().stream().filter(other -> !other.equals(gone)).toList());
    }

    void clear() {
        keep(List.of());
    }

    /** Keeps as many of the newest as the preferences have room for. */
    private void keep(List<Path> files) {
        String lines = files.stream().map(Path::toString).collect(Collectors.joining("\n"));
        if (lines.length() > MOST_LETTERS) {
            keep(files.subList(0, files.size() - 1));
        } else {
            store.put(KEY, lines);
        }
    }
}
