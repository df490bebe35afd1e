package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import jdk.jfr.FlightRecorder;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

/** What is forced to the disk, and when, as the JDK's flight recorder notes it. */
class ForcedToDiskTest {

    private static final String TEMPORARY = ".faultline-";

    @TempDir
    private Path folder;

    @TempDir
    private Path recordings;

    @BeforeEach
    void assumeRecorder() {
        assumeTrue(FlightRecorder.isAvailable());
    }

    /** Returns the events of all files and folders that were forced during an action, in order. */
    private List<RecordedEvent> forcedDuring(Executable action) throws Throwable {
        Path dump = recordings.resolve("forced.jfr");
        try (Recording recording = new Recording()) {
            recording.enable("jdk.FileForce").withoutThreshold().withoutStackTrace();
            recording.start();
            action.execute();
            recording.stop();
            recording.dump(dump);
        }
        return RecordingFile.readAllEvents(dump).stream()
                .filter(event -> Path.of(event.getString("path")).startsWith(folder))
                .toList();
    }

    private static Path path(RecordedEvent forced) {
        return Path.of(forced.getString("path"));
    }

    private void assertTemporary(RecordedEvent forced) {
        assertEquals(folder, path(forced).getParent());
        assertTrue(path(forced).getFileName().toString().startsWith(TEMPORARY), path(forced)::toString);
    }

    @Test
    void theContentIsForcedToTheDiskAndAfterTheMoveTheFolder() throws Throwable {
        List<RecordedEvent> forced = forcedDuring(() -> AtomicFile.write(folder.resolve("a.txt"), new byte[] {1}));
        assertEquals(2, forced.size());
        assertTemporary(forced.get(0));
        assertTrue(forced.get(0).getBoolean("metaData"));
        assertEquals(folder, path(forced.get(1)));
    }

    /** If the move fails, all that was forced was forced before it. */
    @Test
    void theContentIsForcedBeforeTheMove() throws Throwable {
        Path target = folder.resolve("a.txt");
        List<RecordedEvent> forced = forcedDuring(() -> {
            try (AtomicFile out = AtomicFile.create(target)) {
                out.stream().write(1);
                Files.createDirectory(target);
                assertThrows(IOException.class, out::commit);
            }
        });
        assertEquals(1, forced.size());
        assertTemporary(forced.get(0));
    }

    @Test
    void aLongFileIsForcedWhileItIsWritten() throws Throwable {
        List<RecordedEvent> forced = forcedDuring(() -> {
            try (AtomicFile out = AtomicFile.create(folder.resolve("long.bin"))) {
                out.stream().write(new byte[9 << 20]);
                out.stream().flush();
            }
        });
        assertEquals(1, forced.size());
        assertTemporary(forced.get(0));
    }

    @Test
    void allFilesOfAFolderAreForcedToTheDiskAndThenTheFoldersInWhichTheyAre() throws Throwable {
        Path source = Files.createDirectory(recordings.resolve("source"));
        Path first = Files.writeString(source.resolve("first.csv"), "1");
        Path inside = Files.createDirectory(source.resolve("plan"));
        Path second = Files.writeString(inside.resolve("second.xml"), "2");
        Path target = folder.resolve("target");
        List<Path> forced = forcedDuring(() -> AtomicFolder.copy(source, List.of(first, second), target)).stream()
                .map(ForcedToDiskTest::path)
                .toList();
        Path part = forced.get(0).getParent();
        assertEquals(folder, part.getParent());
        assertEquals(
                List.of(part.resolve("first.csv"), part.resolve("plan/second.xml"), part, part.resolve("plan"), folder),
                forced.stream().distinct().toList());
        assertEquals("2", Files.readString(target.resolve("plan/second.xml")));
    }

    @Test
    void aFileThatIsNotCommittedIsNotForced() throws Throwable {
        List<RecordedEvent> forced = forcedDuring(() -> {
            try (AtomicFile out = AtomicFile.create(folder.resolve("a.txt"))) {
                out.stream().write(1);
            }
        });
        assertEquals(List.of(), forced);
    }
}
