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
    void onlyWordsThatAreNoNamesAreCommands() {
        assertFalse(ControllerChoice.isCommand(ControllerNames.WALL_FOLLOWER));
        assertFalse(ControllerChoice.isCommand(ControllerNames.NONE));
        assertTrue(ControllerChoice.isCommand("none "));
    }
}
