package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WriteProblemTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        "No space left on device, 1000000, DISK_FULL",
        "Brak miejsca na urządzeniu, 65535, DISK_FULL",
        "Brak miejsca na urządzeniu, 0, DISK_FULL",
        "Błąd wejścia/wyjścia, 65536, INTERRUPTED",
        "Broken pipe, 0, BROKEN_PIPE"
    })
    void aFullDiskIsRecognisedInAnyLanguageByTheRoomThatIsLeft(String system, long room, WriteProblem problem) {
        assertEquals(problem, WriteProblem.of(system, room));
    }

    @ParameterizedTest
    @CsvSource({"250, NAME_TOO_LONG", "249, CANNOT_WRITE"})
    void aNameThatIsTooLongIsRecognisedInAnyLanguage(int length, WriteProblem problem) {
        Path file = folder.resolve("ż".repeat(3) + "x".repeat(length));
        assertEquals(problem, WriteProblem.ofCreation(file, new FileSystemException("", null, "Zbyt długa nazwa")));
    }

    @Test
    void theReasonWhyAFileCannotBeCreatedIsNamed() {
        Path file = folder.resolve("a.csv");
        assertEquals(WriteProblem.FOLDER_READ_ONLY, WriteProblem.ofCreation(file, new AccessDeniedException("")));
        assertEquals(
                WriteProblem.NAME_TOO_LONG,
                WriteProblem.ofCreation(file, new FileSystemException("", null, "File name too long")));
        assertEquals(
                WriteProblem.NO_FOLDER,
                WriteProblem.ofCreation(folder.resolve("missing/a.csv"), new NoSuchFileException("")));
    }

    @Test
    void withoutADiskTheMessageDecides() {
        assertEquals(WriteProblem.INTERRUPTED, WriteProblem.of("Input/output error", Long.MAX_VALUE));
        assertEquals(WriteProblem.DISK_FULL, WriteProblem.of("Disk quota exceeded", Long.MAX_VALUE));
    }

    @Test
    void theRoomIsThatOfTheDiskOfTheFile() throws IOException {
        Path file = folder.resolve("new.csv");
        assertTrue(WriteProblem.room(file).orElseThrow() > 0);
        assertTrue(WriteProblem.room(Files.createSymbolicLink(folder.resolve("link"), file))
                .isPresent());
        assertEquals(OptionalLong.empty(), WriteProblem.room(folder.resolve("missing/new.csv")));
    }

    @Test
    void aFileOfTheSystemIsOnNoDisk() {
        Path file = Path.of("/proc/version");
        assumeTrue(Files.exists(file));
        assertEquals(OptionalLong.empty(), WriteProblem.room(file));
    }
}
