package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.external.ControllerChoice;
import faultline.gui.BackgroundThreads;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What the dialog of the controllers offers. */
class ControllerDialogTest {

    @TempDir
    private Path folder;

    @AfterEach
    void restoreChoices() {
        runOnEdt(() -> {
            Messages.setLanguage(Language.ENGLISH);
            TextSize.NORMAL.install();
            Theme.LIGHT.install();
        });
    }

    private Path startFolder(ControllerChoice now, Path scenario) {
        return callOnEdt(() -> new ControllerDialog("chooseController", now, scenario, List.of())
                .startFolder()
                .toPath());
    }

    private Path create(String name) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, "");
    }

    @Test
    void filesAreChosenBesideTheProgramOfTheController() throws IOException {
        Path program = create("my controllers/follow.py");
        ControllerChoice command = ControllerChoice.of("python3 \"" + program + "\"");
        assertEquals(program.getParent(), startFolder(command, create("rooms/room.xml")));
    }

    @Test
    void filesAreChosenBesideTheJarOfTheController() throws IOException {
        Path jar = create("jars/controllers.jar");
        assertEquals(jar.getParent(), startFolder(new ControllerChoice("bug2", List.of(jar)), null));
    }

    @Test
    void filesAreChosenBesideTheOpenScenarioIfTheControllerHasNone() throws IOException {
        Path scenario = create("rooms/room.xml");
        assertEquals(scenario.getParent(), startFolder(ControllerChoice.SCENARIO, scenario));
        assertEquals(scenario.getParent(), startFolder(ControllerChoice.of("wall-follower"), scenario));
    }

    @Test
    void filesAreChosenInTheWorkingDirectoryIfNoFileIsOpen() {
        assertEquals(Path.of("").toAbsolutePath(), startFolder(ControllerChoice.SCENARIO, null));
    }

    /** The screen has 800 pixels, of which the frame and the borders of the dialog take less than 100. */
    @ParameterizedTest
    @EnumSource(Language.class)
    void withTheLargestTextItFitsOnASmallScreen(Language language) {
        int width = callOnEdt(() -> {
            Messages.setLanguage(language);
            TextSize.LARGEST.install();
            Theme.LIGHT.install();
            return Stream.of("chooseController", "compareController")
                    .map(key -> new ControllerDialog(key, ControllerChoice.SCENARIO, null, List.of()))
                    .mapToInt(dialog -> dialog.createPanel().getPreferredSize().width)
                    .max()
                    .orElseThrow();
        });
        assertTrue(width <= 700, width + " pixels");
    }

    @Test
    void aGhostIsNotSaidToBeLoadedAgainByARestart() {
        String help = callOnEdt(
                () -> new ControllerDialog("compareController", ControllerChoice.SCENARIO, null, List.of()).help());
        assertTrue(help.endsWith("The ghost is one run; to load a changed file, choose it again."), help);
    }

    @Test
    void theListEndsWithTheCommandsThatWereUsedLast() {
        List<String> recent = List.of("python3 newer.py", "python3 older.py");
        ControllerDialog dialog =
                callOnEdt(() -> new ControllerDialog("chooseController", ControllerChoice.SCENARIO, null, recent));
        BackgroundThreads.awaitEnd();
        List<String> names = callOnEdt(dialog::names);
        assertEquals("As in the scenario", names.get(0));
        assertTrue(names.contains("wall-follower"), names.toString());
        assertEquals(recent, names.subList(names.size() - 2, names.size()));
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
