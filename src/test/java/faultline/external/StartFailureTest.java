package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.io.ShellText;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Reasons why a program cannot be started, in the words of several versions of the JDK. */
class StartFailureTest {

    private static String describe(String program, String message) {
        return StartFailure.describe(program, message).toString();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Cannot run program \"x\": error=2, No such file or directory | there is no such program",
                "Cannot run program \"x\": Exec failed, error: 2 (No such file) | there is no such program",
                "Cannot run program \"x\": error=13, Permission denied | the file is not executable",
                "Cannot run program \"x\": CreateProcess error=193, %1 is not a valid Win32 application "
                        + "| the file is not a program",
                "Cannot run program \"x\": Exec failed, error: 7 (Argument list too long) | Argument list too long",
                "the command is too odd | the command is too odd"
            })
    void theReasonIsInPlainWords(String message, String reason) {
        assertEquals(reason, describe("x", message));
    }

    @Test
    void aScriptWithoutItsInterpreterIsNotCalledMissing(@TempDir Path folder) throws IOException {
        Path script = Files.writeString(folder.resolve("follower"), "#!/no/such/python");
        assertEquals(
                "the interpreter that its first line names does not exist",
                describe(script.toString(), "Cannot run program: error=2, No such file or directory"));
    }

    @Test
    void aProgramInPythonIsNamedWithItsInterpreter(@TempDir Path folder) throws IOException {
        Path script = Files.writeString(folder.resolve("my.py"), "import faultline");
        assertEquals(
                "the file is not executable; a program in Python is started by \"" + PythonCommand.text() + " "
                        + ShellText.quoted(script.toString()) + "\"",
                describe(script.toString(), "Cannot run program: error=13, Permission denied"));
    }

    @Test
    void aFolderIsNoProgram(@TempDir Path folder) {
        assertEquals(
                "this is a folder; expected a program",
                describe(folder.toString(), "Cannot run program: error=13, Permission denied"));
    }

    @Test
    void anUnquotedPathWithBlanksIsGivenInQuotes(@TempDir Path folder) throws IOException {
        String script = Files.writeString(folder.resolve("my robot.py"), "import faultline")
                .toString();
        assertEquals(
                "; a path with blanks is one word in quotes: \"" + script + "\"",
                ControllerNames.hint(script).toString());
        assertEquals("", ControllerNames.hint(script + " x").toString());
    }

    @Test
    void aJarIsNoProgram() {
        assertEquals(
                "the file is not executable; the controllers of a jar are added with --jar or in the window with"
                        + " \"File\", and chosen by name",
                describe("my.jar", "Cannot run program: error=13, Permission denied"));
    }

    @Test
    void theUsualNameOfPythonIsSuggestedForAnotherOne() {
        String missing = "Cannot run program: error=2, No such file or directory";
        String python = PythonCommand.text();
        assertEquals(
                "there is no such program; Python is usually started by \"" + python + "\"",
                describe("python", missing));
        assertEquals("there is no such program", describe(python, missing));
        assertEquals("there is no such program", describe("pythonic", missing));
    }

    @Test
    void onWindowsPythonIsStartedByItsLauncher() {
        assertEquals("py", PythonCommand.text('\\'));
        assertEquals("python3", PythonCommand.text('/'));
    }

    @Test
    void aFileInTheCurrentFolderIsNoProgramByItsNameAlone() {
        assertEquals(
                "there is no such program",
                describe("pom.xml", "Cannot run program: error=2, No such file or directory"));
    }
}
