package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.io.JsonWriter;
import faultline.io.ProgramVersion;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What a choice of a controller means. */
class ControllerChoiceTest {

    @TempDir
    private Path folder;

    private static SimulationSetup yard() throws Exception {
        return Scenario.loadShipped("yard.xml").setup();
    }

    @Test
    void theFilesAreTheJarsAndTheWordsOfACommandThatNameFiles() throws IOException {
        Path script = Files.createFile(folder.resolve("my follower.py"));
        Path settings = Files.createFile(folder.resolve("settings"));
        Path jar = folder.resolve("mine.jar");
        String command = "python3 '" + script + "' " + settings + " " + folder + " none";
        assertEquals(List.of(script, settings), ControllerChoice.of(command).files());
        assertEquals(List.of(jar, script, settings), new ControllerChoice(command, List.of(jar)).files());
        assertEquals(
                List.of(jar),
                new ControllerChoice("python3 '" + script, List.of(jar)).files(),
                "a quote without an end");
        assertEquals(List.of(), ControllerChoice.of("a\0b").files());
        assertEquals(List.of(), ControllerChoice.SCENARIO.files());
    }

    @Test
    void onlyWordsThatAreNoNamesAreCommands() {
        assertFalse(ControllerChoice.of(ControllerNames.WALL_FOLLOWER).isCommand());
        assertFalse(ControllerChoice.of(ControllerNames.NONE).isCommand());
        assertTrue(ControllerChoice.of("none ").isCommand());
        assertFalse(ControllerChoice.SCENARIO.isCommand());
    }

    @Test
    void theScenariosControllerChangesNothing() throws Exception {
        SimulationSetup setup = yard();
        assertSame(setup, ControllerChoice.SCENARIO.applyTo(setup, null));
        assertSame(setup, ControllerChoice.SCENARIO.applyTo(setup, "Yard", line -> {}));
        assertSame(setup, ControllerChoice.SCENARIO.applyByName(setup));
        assertTrue(ControllerChoice.SCENARIO.isScenarioDefault());
        assertFalse(ControllerChoice.of("none").isScenarioDefault());
    }

    @Test
    void aControllerOfTheProgramIsTheOneThatAFileNames() throws Exception {
        SimulationSetup setup = yard().withController(new ControllerSpec.Drive(1, 2));
        for (String name : List.of("wall-follower", "none")) {
            ControllerChoice choice = ControllerChoice.of(name);
            assertTrue(choice.isBuiltIn());
            assertEquals(choice.applyByName(setup), choice.applyTo(setup, null));
        }
        assertFalse(ControllerChoice.of("drive").isBuiltIn());
    }

    @Test
    void aWallFollowerKeepsTheSettingsOfTheScenario() throws Exception {
        ControllerSpec own = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.4);
        assertEquals(
                own,
                ControllerChoice.of("wall-follower")
                        .applyTo(yard().withController(own), null)
                        .controller());
    }

    @Test
    void aCommandIsStartedInsteadOfTheControllerOfTheFile() throws Exception {
        ControllerSource commands = new JarControllerSource("child", List.of(), Map.of());
        SimulationSetup setup = yard();
        assertEquals(
                new ControllerSpec.Chosen(setup.controller(), commands),
                ControllerChoice.of("python3 robot.py").applyTo(setup, commands).controller());
    }

    @Test
    void onlyARunWithACommandStartsIt() throws Exception {
        SimulationSetup setup = yard();
        SimulationSetup chosen = ControllerChoice.of("python3 robot.py").applyTo(setup, "Yard", line -> {});
        assertTrue(ControllerChoice.startsCommand(chosen));
        assertFalse(ControllerChoice.startsCommand(setup));
        assertFalse(ControllerChoice.startsCommand(ControllerChoice.of("none").applyTo(setup, "Yard", line -> {})));
        ControllerSource jar = new JarControllerSource("mine", List.of(), Map.of());
        assertFalse(ControllerChoice.startsCommand(
                setup.withController(new ControllerSpec.Chosen(setup.controller(), jar))));
    }

    @Test
    void theFileOfTheScenarioNamesTheController() throws Exception {
        ControllerSpec.Provided own = new ControllerSpec.Provided("mine", 0.05, Map.of("distance", "0.3"));
        SimulationSetup setup = yard().withController(own);
        assertEquals(own, ControllerChoice.of("mine").applyByName(setup).controller(), "with its settings");
        assertEquals(
                new ControllerSpec.Provided("other", 0.05, Map.of()),
                ControllerChoice.of("other").applyByName(setup).controller());
        SimulationSetup far = yard().withController(ControllerSpec.WallFollowing.DEFAULT.withDistance(0.4));
        assertEquals(
                new ControllerSpec.Provided("other", 0, 0.4, Map.of()),
                ControllerChoice.of("other").applyByName(far).controller(),
                "measured by the distance that the scenario wants");
        assertEquals(
                ControllerSpec.WallFollowing.DEFAULT,
                ControllerChoice.of("wall-follower").applyByName(setup).controller());
        assertEquals(
                new ControllerSpec.None(),
                ControllerChoice.of("none").applyByName(setup).controller());
    }

    @Test
    void withoutJarsWorkUsesTheControllersOfItsThread() throws Exception {
        ClassLoader own = Thread.currentThread().getContextClassLoader();
        assertSame(own, ControllerChoice.SCENARIO.callWithJars(() -> Thread.currentThread()
                .getContextClassLoader()));
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void aChildIsGivenTheVersionOfTheProgramAndTheNameOfTheScenario() throws Exception {
        // The message of a child that ends too early repeats what it wrote to standard error.
        ControllerChoice echo = ControllerChoice.of("sh -c 'read hello; echo \"$hello\" >&2'");
        SimulationSetup setup = echo.applyTo(yard(), "Yard", line -> {});
        RunFailedException e =
                assertThrows(RunFailedException.class, () -> new Simulation(setup, ControllerMode.DIRECT));
        String version = JsonWriter.quoted(ProgramVersion.text());
        assertTrue(e.getMessage().contains("\"program\":" + version + ",\"scenario\":\"Yard\""), e.getMessage());
    }
}
