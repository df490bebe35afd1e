package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.JavaProcess;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.AbstractList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFolderTest {

    @TempDir
    private Path folder;

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void aFolderWithAFileThatCannotBeCopiedDoesNotExist() throws IOException {
        Path first = Files.writeString(folder.resolve("first.csv"), "1");
        List<Path> files = List.of(first, folder.resolve("missing.csv"));
        assertThrows(IOException.class, () -> AtomicFolder.copy(folder, files, folder.resolve("target")));
        assertEquals(List.of("first.csv"), names());
    }

    /** Copies a file, and ends the process before it copies the next one. */
    static final class EndedCopy {

        private EndedCopy() {}

        public static void main(String[] arguments) throws IOException {
            Path folder = Path.of(arguments[0]);
            List<Path> files = new AbstractList<>() {
                @Override
                public Path get(int index) {
                    if (index == 1) {
                        System.exit(0);
                    }
                    return folder.resolve("first.csv");
                }

                @Override
                public int size() {
                    return 2;
                }
            };
            AtomicFolder.copy(folder, files, folder.resolve("target"));
        }
    }

    @Test
    void theEndOfTheProgramLeavesNoPartOfAFolder() throws Exception {
        Files.writeString(folder.resolve("first.csv"), "1");
        ProcessBuilder builder = JavaProcess.builder(EndedCopy.class.getName(), List.of());
        builder.command().add(folder.toString());
        assertEquals("", JavaProcess.output(builder.start()));
        assertEquals(List.of("first.csv"), names());
    }
}
