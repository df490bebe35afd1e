package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sentences about files and folders that do not depend on the language of the system. */
class FileProblemTest {

    @TempDir
    private Path folder;

    private static String reason(Path file, String system) {
        return FileProblem.reason(new FileSystemException(file.toString(), null, system));
    }

    @Test
    void aFileInTheMiddleOfAPathIsNamedInAnyLanguage() throws IOException {
        Path file = Files.createFile(folder.resolve("file"));
        assertEquals(
                "a part of this path is a file; expected a folder", reason(file.resolve("x"), "Nie jest katalogiem"));
        assertEquals(
                "a part of this path is a file; expected a folder", reason(file.resolve("x/y"), "Nie jest katalogiem"));
    }

    @Test
    void aNameThatIsTooLongIsRecognisedInAnyLanguage() {
        String longest = "x".repeat(255);
        assertEquals("its name is too long", reason(folder.resolve(longest + "x"), "Zbyt długa nazwa"));
        assertEquals("its name is too long", reason(folder.resolve("ż" + longest + "/a"), "Zbyt długa nazwa"));
        assertEquals("Zbyt długa nazwa", reason(folder.resolve(longest), "Zbyt długa nazwa"));
        assertEquals("its name is too long", reason(folder.resolve(longest), "File name too long"));
    }

    @Test
    void exceptionsOfTheJdkAreSentences() throws IOException {
        String file = Files.createFile(folder.resolve("file")).toString();
        assertEquals("there is no such file", FileProblem.reason(new NoSuchFileException("x")));
        assertEquals("access is denied", FileProblem.reason(new AccessDeniedException("x")));
        assertEquals("this is a file; expected a folder", FileProblem.reason(new FileAlreadyExistsException(file)));
        assertEquals("the file cannot be used", FileProblem.reason(new FileSystemException(file)));
    }
}
