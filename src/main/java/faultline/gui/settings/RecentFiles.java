package faultline.gui.settings;

import faultline.gui.settings.WindowPreferences.PreferenceStore;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The files opened most recently, newest first. */
public final class RecentFiles {

    private static final String PREFERENCE_KEY = "recent";
    private static final int MAX_FILES = 8;
    /** The longest value that a preference may have. */
    private static final int MAX_TEXT_LENGTH = 8192;

    private static final Pattern LINE_BREAK = Pattern.compile("[\\n\\r]");

    private final PreferenceStore store;

    RecentFiles(PreferenceStore store) {
        this.store = store;
    }

    /** Returns the files, newest first; they may no longer exist. */
    public List<Path> files() {
        return store.get(PREFERENCE_KEY).lines().flatMap(RecentFiles::parsePath).toList();
    }

    private static Stream<Path> parsePath(String line) {
        try {
            return line.isBlank() ? Stream.empty() : Stream.of(Path.of(line));
        } catch (InvalidPathException damaged) {
            return Stream.empty();
        }
    }

    /** Adds a file as the newest one. One whose name has a line break is not kept, because lines separate the names. */
    public void add(Path file) {
        Path newest = file.toAbsolutePath().normalize();
        if (!LINE_BREAK.matcher(newest.toString()).find()) {
            store(Stream.concat(Stream.of(newest), files().stream().filter(other -> !other.equals(newest)))
                    .limit(MAX_FILES)
                    .toList());
        }
    }

    public void remove(Path file) {
        Path gone = file.toAbsolutePath().normalize();
        store(files().stream().filter(other -> !other.equals(gone)).toList());
    }

    public void clear() {
        store(List.of());
    }

    /** Stores as many of the newest files as the preferences have room for. */
    private void store(List<Path> files) {
        String lines = files.stream().map(Path::toString).collect(Collectors.joining("\n"));
        if (lines.length() > MAX_TEXT_LENGTH) {
            store(files.subList(0, files.size() - 1));
        } else {
            store.put(PREFERENCE_KEY, lines);
        }
    }
}
