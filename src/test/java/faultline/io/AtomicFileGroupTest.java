package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files of one command. */
class AtomicFileGroupTest {

    @TempDir
    private Path folder;

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }

    @Test
    void aCommitMovesAllFilesIntoPlace() throws IOException {
        Path old = Files.writeString(folder.resolve("a"), "old");
        try (AtomicFileGroup group = new AtomicFileGroup()) {
            group.write(old, new byte[] {'x'});
            group.create(folder.resolve("b")).stream().write('y');
            assertEquals("old", Files.readString(old));
            group.commit();
        }
        assertEquals("x", Files.readString(old));
        assertEquals("y", Files.readString(folder.resolve("b")));
    }

    @Test
    void aCommitDeletesTheOldFileInThePlaceOfADiscardedOne() throws IOException {
        Path old = Files.writeString(folder.resolve("a"), "old");
        try (AtomicFileGroup group = new AtomicFileGroup()) {
            group.discard(group.create(old));
            group.discard(group.create(folder.resolve("never-written")));
            group.write(folder.resolve("b"), new byte[] {'y'});
            assertEquals("old", Files.readString(old));
            group.commit();
        }
        assertEquals(List.of(folder.resolve("b")), files());
    }

    @Test
    void withoutACommitNothingChanges() throws IOException {
        Path old = Files.writeString(folder.resolve("a"), "old");
        try (AtomicFileGroup group = new AtomicFileGroup()) {
            group.write(old, new byte[] {'x'});
            group.write(folder.resolve("b"), new byte[] {'y'});
        }
        assertEquals("old", Files.readString(old));
        assertEquals(List.of(old), files());
    }

    @Test
    void aThreadThatIsLateCreatesNoFileInAClosedGroup() throws IOException {
        AtomicFileGroup group = new AtomicFileGroup();
        group.close();
        assertThrows(IllegalStateException.class, () -> group.create(folder.resolve("late")));
        assertEquals(List.of(), files());
    }

    @Test
    void aFileThatCannotBeDeletedDoesNotKeepTheOthers() throws IOException {
        AtomicFileGroup group = new AtomicFileGroup();
        group.create(folder.resolve("a"));
        Path first = files().get(0);
        group.create(folder.resolve("b"));
        Files.delete(first);
        Path inside = Files.createFile(Files.createDirectory(first).resolve("inside"));
        assertThrows(DirectoryNotEmptyException.class, group::close);
        assertEquals(List.of(first), files());
        Files.delete(inside);
    }
}
