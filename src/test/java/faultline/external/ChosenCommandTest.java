package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a choice of a controller means if it is not the name of one. */
class ChosenCommandTest {

    @TempDir
    private Path folder;

    @Test
    void theFilesOfACommandAreItsWordsThatNameFiles() throws IOException {
        Path script = Files.createFile(folder.resolve("my follower.py"));
        Path settings = Files.createFile(folder.resolve("settings"));
        assertEquals(
                List.of(script, settings),
                ControllerChoice.files("python3 '" + script + "' " + settings + " " + folder + " none"));
        assertEquals(List.of(), ControllerChoice.files("python3 '" + script), "a quote without an end");
        assertEquals(List.of(), ControllerChoice.files("a\0b"));
    }

    @Test
    void aWordThatIsNearlyANameGetsAHint() {
        String hint = ControllerChoice.hint("wall-folower").toString();
        assertTrue(hint.contains("wall-follower") && hint.contains("did you mean"), hint);
        String names = ControllerChoice.hint("somethingelse").toString();
        assertTrue(names.contains("wall-follower, none") && !names.contains("did you mean"), names);
        for (String command : List.of("wall folower", "./none", "bin\\none")) {
            assertEquals("", ControllerChoice.hint(command));
        }
    }

    @Test
    void onlyWordsThatAreNoNamesAreCommands() {
        assertFalse(ControllerChoice.isCommand(ControllerChoice.WALL_FOLLOWER));
        assertFalse(ControllerChoice.isCommand(ControllerChoice.NONE));
        assertTrue(ControllerChoice.isCommand("none "));
    }
}
