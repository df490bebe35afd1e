package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.document.ControllerSelection;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the dialog of the controllers offers. */
class ControllerDialogTest {

    @TempDir
    private Path folder;

    @AfterEach
    void speakEnglish() {
        runOnEdt(() -> Messages.setLanguage(Language.ENGLISH));
    }

    private Path startFolder(ControllerSelection now, Path scenario) {
        return callOnEdt(() ->
                new ControllerDialog("Controller", now, scenario).startFolder().toPath());
    }

    private Path create(String name) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, "");
    }

    @Test
    void filesAreChosenBesideTheProgramOfTheController() throws IOException {
        Path program = create("my controllers/follow.py");
        ControllerSelection command = new ControllerSelection("python3 \"" + program + "\"", List.of());
        assertEquals(program.getParent(), startFolder(command, create("rooms/room.xml")));
    }

    @Test
    void filesAreChosenBesideTheJarOfTheController() throws IOException {
        Path jar = create("jars/controllers.jar");
        assertEquals(jar.getParent(), startFolder(new ControllerSelection("bug2", List.of(jar)), null));
    }

    @Test
    void filesAreChosenBesideTheOpenScenarioIfTheControllerHasNone() throws IOException {
        Path scenario = create("rooms/room.xml");
        assertEquals(scenario.getParent(), startFolder(ControllerSelection.SCENARIO, scenario));
        assertEquals(scenario.getParent(), startFolder(new ControllerSelection("wall-follower", List.of()), scenario));
    }

    @Test
    void filesAreChosenInTheWorkingDirectoryIfNoFileIsOpen() {
        assertEquals(Path.of("").toAbsolutePath(), startFolder(ControllerSelection.SCENARIO, null));
    }

    @Test
    void theListNamesTheControllersOfTheProgram() {
        assertEquals("Wall follower (wall-follower)", ControllerDialog.nameOf("wall-follower"));
        assertEquals("None (none)", ControllerDialog.nameOf("none"));
        assertEquals("bug2", ControllerDialog.nameOf("bug2"));
        runOnEdt(() -> Messages.setLanguage(Language.POLISH));
        assertEquals("Jazda wzdłuż ściany (wall-follower)", ControllerDialog.nameOf("wall-follower"));
    }
}
