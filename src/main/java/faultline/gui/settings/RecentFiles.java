package faultline.gui.settings;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The files opened most recently, newest first. */
public final class RecentFiles {

    private final RecentTexts names;

    RecentFiles(RecentTexts names) {
        this.names = names;
    }

    /** Returns the files, newest first; they may no longer exist. */
    public List<Path> files() {
        return names.texts().stream().flatMap(RecentFiles::parsePath).toList();
    }

    private static Stream<Path> parsePath(String name) {
        try {
            return Stream.of(Path.of(name));
        } catch (InvalidPathException damaged) {
            return Stream.empty();
        }
    }

    /** Adds a file as the newest one. One whose name has a line break or a control character is not kept. */
    public void add(Path file) {
        names.add(nameOf(file));
    }

    public void remove(Path file) {
        names.remove(nameOf(file));
    }

    public void clear() {
        names.clear();
    }

    private static String nameOf(Path file) {
        return file.toAbsolutePath().normalize().toString();
    }
}
