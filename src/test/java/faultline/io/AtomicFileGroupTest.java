package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.CopyOption;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
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
    void aFileThatIsAnotherOneOfTheGroupByALinkIsRefused() throws IOException {
        Path other = folder.resolve("other");
        Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("other"));
        try (AtomicFileGroup group = new AtomicFileGroup()) {
            group.write(other, new byte[] {'x'});
            MessageException refusal = assertThrows(MessageException.class, () -> group.create(link));
            assertEquals(link + ": another output is the same file; expected a file of its own", refusal.getMessage());
            group.commit();
        }
        assertEquals("x", Files.readString(other));
        assertEquals(List.of(link, other), files());
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "there is no null device of this name")
    void severalFilesMayBeTheSameDevice() throws IOException {
        try (AtomicFileGroup group = new AtomicFileGroup()) {
            group.write(Path.of("/dev/null"), new byte[] {'x'});
            group.write(Path.of("/dev/null"), new byte[] {'y'});
            group.commit();
        }
        assertEquals(List.of(), files());
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

    @Test
    void everyFileThatCannotBeDeletedIsReported() throws IOException {
        AtomicFileGroup group = new AtomicFileGroup();
        group.create(folder.resolve("a"));
        Path first = files().get(0);
        group.create(folder.resolve("b"));
        Path second =
                files().stream().filter(file -> !file.equals(first)).findFirst().orElseThrow();
        for (Path file : List.of(first, second)) {
            Files.delete(file);
            Files.createFile(Files.createDirectory(file).resolve("inside"));
        }
        IOException failure = assertThrows(DirectoryNotEmptyException.class, group::close);
        assertEquals(first.toString(), failure.getMessage());
        assertEquals(
                List.of(second.toString()),
                Arrays.stream(failure.getSuppressed())
                        .map(Throwable::getMessage)
                        .toList());
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "there are no named pipes")
    void aPipeInThePlaceOfADiscardedFileStays() throws Exception {
        Path pipe = folder.resolve("pipe");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
        Process reader = new ProcessBuilder("cat", pipe.toString()).start();
        try (AtomicFileGroup group = new AtomicFileGroup()) {
            group.discard(group.create(pipe));
            group.commit();
        }
        assertEquals(0, reader.waitFor());
        assertEquals(List.of(pipe), files());
    }

    /** Network file systems and those that join several others may have no such move. */
    @Test
    void aFileIsReplacedWhereTheSystemHasNoAtomicMove() throws IOException {
        ForwardingFileSystemProvider twoSteps = new ForwardingFileSystemProvider() {
            @Override
            public void move(Path source, Path target, CopyOption... options) throws IOException {
                if (List.of(options).contains(StandardCopyOption.ATOMIC_MOVE)) {
                    throw new AtomicMoveNotSupportedException(source.toString(), target.toString(), "another disk");
                }
                super.move(source, target, options);
            }
        };
        Path old = Files.writeString(folder.resolve("a"), "old");
        AtomicFile.write(twoSteps.forwarding(old), new byte[] {'x'});
        assertEquals("x", Files.readString(old));
        assertEquals(List.of(old), files());
    }
}
