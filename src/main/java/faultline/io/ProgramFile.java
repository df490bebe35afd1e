package faultline.io;

import java.net.URISyntaxException;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Optional;

/** Finds the program's own file. Safe on any thread. */
public final class ProgramFile {

    private ProgramFile() {}

    /**
     * {@return the jar of this program, or the folder of its classes; empty if it is not known, as for classes that are
     * appended to those of the virtual machine, or not in a file}
     */
    public static Optional<Path> find() {
        CodeSource source = ProgramFile.class.getProtectionDomain().getCodeSource();
        if (source == null || source.getLocation() == null) {
            return Optional.empty();
        }
        try {
            return Optional.of(Path.of(source.getLocation().toURI()));
        } catch (URISyntaxException | IllegalArgumentException | FileSystemNotFoundException noFile) {
            return Optional.empty();
        }
    }
}
