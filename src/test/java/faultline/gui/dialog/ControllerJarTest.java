package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerProvider;
import faultline.external.PythonCommand;
import faultline.external.RightTurner;
import faultline.external.ShellWords;
import faultline.gui.EdtChecker;
import faultline.gui.document.ControllerSelection;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Jars in the dialog that asks for a controller, without a display. */
@ExtendWith(EdtChecker.class)
class ControllerJarTest {

    private static final String COMMAND = "python3 robot.py";

    @TempDir
    private Path folder;

    private ControllerDialog dialog;

    @BeforeEach
    void create() {
        dialog = callOnEdt(() -> new ControllerDialog("Controller", new ControllerSelection(COMMAND, List.of()), null));
    }

    private Path jar(String name, String provider) throws IOException {
        Path jar = folder.resolve(name);
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry("META-INF/services/" + ControllerProvider.class.getName()));
            out.write(provider.getBytes(StandardCharsets.UTF_8));
        }
        return jar;
    }

    @Test
    void aJarWithoutAControllerIsReported() throws IOException {
        Path empty = jar("empty.jar", "");
        runOnEdt(() -> dialog.useFile(empty));
        assertEquals("empty.jar adds no controller", callOnEdt(dialog::help));
        assertEquals(COMMAND, callOnEdt(dialog::text));
    }

    @Test
    void aJarWhoseControllerCannotBeLoadedIsReported() throws IOException {
        Path broken = jar("broken.jar", "no.such.Turner");
        runOnEdt(() -> dialog.useFile(broken));
        assertEquals(
                "a controller in Java cannot be loaded: faultline.control.ControllerProvider:\n"
                        + "Provider no.such.Turner not found",
                callOnEdt(dialog::help));
        assertEquals(COMMAND, callOnEdt(dialog::text));
        Path good = jar("turner.jar", RightTurner.class.getName());
        runOnEdt(() -> dialog.useFile(good));
        assertEquals("right-turner", callOnEdt(dialog::text));
    }

    @Test
    void theDialogOpensWithAJarThatIsBrokenNow() throws IOException {
        ControllerSelection chosen = new ControllerSelection("turner", List.of(jar("broken.jar", "no.such.Turner")));
        ControllerDialog reopened = callOnEdt(() -> new ControllerDialog("Controller", chosen, null));
        assertEquals("turner", callOnEdt(reopened::text));
        assertTrue(callOnEdt(reopened::help).startsWith("a controller in Java cannot be loaded: "), reopened::help);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "no file has such a name there")
    void aProgramWhoseNameHasQuotesIsOneWordOfItsCommand() {
        Path script = Path.of("say \\\"hi\\\".py");
        runOnEdt(() -> dialog.useFile(script));
        assertEquals(List.of(PythonCommand.text(), script.toString()), ShellWords.split(callOnEdt(dialog::text)));
    }

    @Test
    void aJarThatIsChosenAgainGivesItsController() throws IOException {
        Path jar = jar("turner.jar", RightTurner.class.getName());
        Path script = folder.resolve("robot.py");
        runOnEdt(() -> dialog.useFile(jar));
        assertEquals("right-turner", callOnEdt(dialog::text));
        runOnEdt(() -> dialog.useFile(script));
        String python = PythonCommand.text();
        assertEquals(python + " " + ShellWords.quoted(script.toString()), callOnEdt(dialog::text));
        runOnEdt(() -> dialog.useFile(jar));
        assertEquals("right-turner", callOnEdt(dialog::text));
        assertEquals(
                "For example: " + python + " \"my follower.py\".\nEach restart loads it again.",
                callOnEdt(dialog::help));
    }
}
