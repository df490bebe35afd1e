package faultline.gui.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.PlanFiles;
import faultline.campaign.run.Outcome;
import faultline.campaign.run.ReplayScenario;
import faultline.control.ControllerProvider;
import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.external.ControllerChoice;
import faultline.external.ControllerNames;
import faultline.external.RightTurner;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioRun;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Which controllers can drive a batch, and a batch that one from a jar drives. */
class BatchControllerItemTest {

    private static final String NAME = "right-turner";

    @TempDir
    private Path folder;

    private Scenario yard;

    @BeforeEach
    void load() throws Exception {
        yard = Scenario.load(Path.of("scenarios/yard.xml"));
    }

    @AfterEach
    void restoreLanguage() {
        Messages.setLanguage(Language.ENGLISH);
    }

    private static SimulationSetup with(SimulationSetup setup, ControllerSpec controller) {
        return setup.withController(controller);
    }

    private static List<String> texts(SimulationSetup setup, ControllerChoice chosen, boolean program) {
        return BatchControllerItem.items(setup, chosen, program).stream()
                .map(item -> item.text(setup))
                .toList();
    }

    @Test
    void aScenarioIsDrivenByItsOwnController() {
        List<String> own = List.of("As in the scenario: wall follower");
        assertEquals(own, texts(yard.setup(), ControllerChoice.SCENARIO, false));
        assertEquals(
                own, texts(yard.setup(), ControllerChoice.of(ControllerNames.WALL_FOLLOWER), false), "the same one");
        assertEquals(own, texts(yard.setup(), ControllerChoice.of("python3 robot.py"), true), "no program is started");
    }

    @Test
    void theControllerOfTheWindowIsTheFirstChoice() {
        assertEquals(
                List.of("Chosen in the window: my-follower", "As in the scenario: wall follower"),
                texts(yard.setup(), ControllerChoice.of("my-follower"), false));
        assertEquals(
                List.of("Chosen in the window: none", "As in the scenario: wall follower"),
                texts(yard.setup(), ControllerChoice.of(ControllerNames.NONE), false));
    }

    @Test
    void theBuiltInFollowerDrivesScenariosOfOtherControllers() {
        SimulationSetup drive = with(yard.setup(), new ControllerSpec.Drive(2, 1));
        assertEquals(
                List.of("As in the scenario: constant voltages", "Built in: wall follower"),
                texts(drive, ControllerChoice.SCENARIO, false));
        assertEquals(
                List.of("Chosen in the window: wall follower", "As in the scenario: constant voltages"),
                texts(drive, ControllerChoice.of(ControllerNames.WALL_FOLLOWER), false));
        SimulationSetup extern = with(yard.setup(), new ControllerSpec.Extern(0));
        assertEquals(
                List.of("Built in: wall follower"),
                texts(extern, ControllerChoice.of("python3 robot.py"), true),
                "a plan cannot name the program");
    }

    @Test
    void controllersAreNamedInTheLanguageOfTheWindow() {
        Messages.setLanguage(Language.POLISH);
        assertEquals(
                List.of("Wybrany w oknie: my-follower", "Jak w scenariuszu: jazda wzdłuż ściany"),
                texts(yard.setup(), ControllerChoice.of("my-follower"), false));
    }

    private Path jar() throws IOException {
        Path jar = folder.resolve("turner.jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry("META-INF/services/" + ControllerProvider.class.getName()));
            out.write(RightTurner.class.getName().getBytes(StandardCharsets.UTF_8));
        }
        return jar;
    }

    @Test
    void aControllerFromAJarDrivesABatchAndItsRunsInTheWindow() throws Exception {
        ControllerChoice chosen = new ControllerChoice(NAME, List.of(jar()));
        assertFalse(chosen.isCommand());
        assertTrue(ControllerChoice.of(NAME).isCommand(), "without the jar, it is a command");
        BatchControllerItem controller =
                BatchControllerItem.items(yard.setup(), chosen, false).get(0);
        Scenario driven = yard.withSetup(controller.applyTo(yard.setup()));
        BatchRun run = new BatchRun(
                new BatchPlan(
                        driven,
                        1,
                        2,
                        3,
                        false,
                        DiagnosisChoice.SCENARIO,
                        true,
                        List.of(new BatchPlan.FaultValues("stuck", "0.3")),
                        "1",
                        List.of("front")),
                2);
        assertEquals(4, chosen.callWithJars(run::make).made());
        run.saveResults(folder.resolve("results"));
        run.delete();
        assertEquals(List.of(NAME), run.planOrNull().controllerTypes());
        BatchResults results = new BatchResults(run.planOrNull());
        for (List<String> row = run.takeRow(); row != null; row = run.takeRow()) {
            results.add(row);
        }
        assertNotEquals("broken", results.value(0, "outcome"), results.value(0, "failure"));
        Scenario first = chosen.callWithJars(() -> ReplayScenario.of(run.planOrNull(), 0, Outcome.LOST, 3));
        SimulationSetup inWindow = chosen.applyTo(first.setup(), first.name(), line -> {});
        ScenarioRun again = first.withSetup(inWindow).run();
        assertEquals(results.value(0, "trajectory_hash"), again.trajectoryHash());
        Path plan = folder.resolve("results/plan/plan.xml");
        assertEquals(
                4, chosen.callWithJars(() -> PlanFiles.read(plan)).runCount(), "the command campaign reads the plan");
    }
}
