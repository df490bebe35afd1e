package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {

    @TempDir
    private Path folder;

    private void write(Path file, String text, boolean commit) throws IOException {
        try (AtomicFile out = AtomicFile.create(file)) {
            out.stream().write(text.getBytes(StandardCharsets.UTF_8));
            if (commit) {
                out.commit();
            }
        }
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }

    @Test
    void aCommittedFileTakesTheOldOnesPlace() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        write(file, "new", true);
        assertEquals("new", Files.readString(file));
        assertEquals(List.of(file), files());
    }

    @Test
    void withoutACommitTheOldFileStaysAndNothingElse() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        write(file, "new", false);
        assertEquals("old", Files.readString(file));
        assertEquals(List.of(file), files());
    }

    @Test
    void ofTwoThatAreWrittenAtOnceTheLastCommittedOneIsThereAsAWhole() throws IOException {
        Path file = folder.resolve("a.txt");
        try (AtomicFile one = AtomicFile.create(file);
                AtomicFile other = AtomicFile.create(file)) {
            one.stream().write("the longer one".getBytes(StandardCharsets.UTF_8));
            other.stream().write("other".getBytes(StandardCharsets.UTF_8));
            one.commit();
            assertEquals("the longer one", Files.readString(file));
            other.commit();
        }
        assertEquals("other", Files.readString(file));
        assertEquals(List.of(file), files());
    }

    @Test
    void aLinkStaysALink() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "old");
        Path link = Files.createSymbolicLink(folder.resolve("link.txt"), file);
        write(link, "new", true);
        assertEquals("new", Files.readString(file));
        assertEquals(file, Files.readSymbolicLink(link));
    }

    @Test
    void aFolderIsRefused() {
        assertEquals(
                folder + ": this is a folder, allowed is a file",
                assertThrows(IOException.class, () -> AtomicFile.create(folder)).getMessage());
    }
}
