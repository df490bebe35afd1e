package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.external.ControllerChoice;
import faultline.external.ShellWords;
import faultline.gui.Await;
import faultline.gui.BackgroundThreads;
import faultline.gui.EdtChecker;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Notes;
import faultline.gui.action.UiAction;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TaskKind;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.settings.WindowPreferences.PreferenceStore;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@ExtendWith(EdtChecker.class)
class ControllerActionsTest {

    private static final Path OFFICE = Path.of("scenarios/office.xml");
    private static final Path CABLE = Path.of("scenarios/cable.xml");
    private static final ControllerChoice MISSING = ControllerChoice.of("no-such-controller");

    private final List<TaskKind> failures = new ArrayList<>();
    private final List<String> notes = new CopyOnWriteArrayList<>();
    /** The notes that stay until they are removed. */
    private final List<String> keptNotes = new CopyOnWriteArrayList<>();

    private final Map<String, String> stored = new HashMap<>();
    private final WindowPreferences preferences =
            new WindowPreferences(new PreferenceStore(key -> stored.getOrDefault(key, ""), stored::put));
    private boolean opensWithoutChoice;
    private int sessions;
    private Workspace workspace;
    private DocumentStore store;
    private RunController run;
    private ComparisonController comparison;
    /** How often there was no ghost, or one that is complete or has failed. */
    private int ghosts;

    private ControllerActions controllers;

    @BeforeEach
    void open() {
        runOnEdt(() -> {
            workspace = new Workspace();
            store = new DocumentStore(workspace);
            run = new RunController(workspace);
            workspace.addListener(new WorkspaceListener() {
                @Override
                public void taskFailed(TaskKind task, Path file, Throwable failure) {
                    failures.add(task);
                    opensWithoutChoice = task == TaskKind.OPEN && controllers.openFailed(failure);
                }

                @Override
                public void sessionStarted() {
                    sessions++;
                }

                @Override
                public void comparisonChanged() {
                    ghosts += comparison.pending().isPresent() ? 0 : 1;
                }
            });
            comparison = new ComparisonController(workspace, run.navigator());
            controllers = new ControllerActions(
                    null,
                    workspace,
                    run,
                    comparison,
                    new Notes(notes::add, keptNotes::add, notes::add, keptNotes::remove),
                    preferences.recentCommands());
            store.open(OFFICE);
        });
        SessionFrames.awaitScenario(workspace);
    }

    @AfterEach
    void close() {
        runOnEdt(() -> {
            controllers.close();
            workspace.close();
        });
    }

    @Test
    void afterAControllerThatCannotBeStartedOtherScenariosCanBeOpened() {
        runOnEdt(() -> controllers.tryOut(MISSING));
        Await.until("the failure", () -> failures.equals(List.of(TaskKind.RESTART)));
        runOnEdt(() -> store.open(CABLE));
        Await.until(
                "the other scenario or a failure",
                () -> failures.size() > 1
                        || workspace.scenario().orElseThrow().name().equals("Cable"));
        assertEquals(List.of(TaskKind.RESTART), callOnEdt(() -> List.copyOf(failures)));
    }

    /** Opens a scenario with a controller of its own; that is cancelled, or the controller cannot be started. */
    private void openInVain(ControllerChoice own, Runnable then) throws Exception {
        Scenario other = Scenario.load(CABLE);
        runOnEdt(() -> {
            controllers.selectForOpening(own);
            store.openGenerated(other, () -> {});
            then.run();
        });
        BackgroundThreads.awaitEnd();
        runOnEdt(() -> {});
        assertEquals(
                "Office", callOnEdt(() -> workspace.scenario().orElseThrow().name()));
    }

    /** The run of a batch is opened with the controller that made it. */
    @Test
    void aCancelledOpenLeavesTheControllerOfTheOpenRun(@TempDir Path folder) throws Exception {
        List<Path> jars = List.of(folder.resolve("mine.jar"));
        runOnEdt(() -> controllers.tryOut(ControllerChoice.of("none")));
        awaitSession(2);
        openInVain(new ControllerChoice("", jars), workspace::cancelTask);
        assertEquals(List.of(), callOnEdt(controllers::jars));
        runOnEdt(run::restart);
        awaitSession(3);
        assertEquals("none", callOnEdt(controllers::chosenText));
    }

    @Test
    void anOpenThatFailsLeavesTheControllerOfTheOpenRun() throws Exception {
        runOnEdt(() -> controllers.tryOut(ControllerChoice.of("none")));
        awaitSession(2);
        openInVain(MISSING, () -> {});
        assertEquals(List.of(TaskKind.OPEN), callOnEdt(() -> List.copyOf(failures)));
        assertFalse(opensWithoutChoice);
        runOnEdt(run::restart);
        awaitSession(3);
        assertEquals("none", callOnEdt(controllers::chosenText));
    }

    @Test
    void aScenarioThatIsOpenedWithItsControllerKeepsIt() throws Exception {
        Scenario other = Scenario.load(CABLE);
        runOnEdt(() -> controllers.tryOut(ControllerChoice.of("none")));
        awaitSession(2);
        runOnEdt(() -> {
            controllers.selectForOpening(ControllerChoice.of("wall-follower"));
            store.openGenerated(other, () -> {});
        });
        awaitSession(3);
        runOnEdt(workspace::cancelTask);
        runOnEdt(run::restart);
        awaitSession(4);
        assertEquals("wall-follower", callOnEdt(controllers::chosenText));
    }

    @ParameterizedTest
    @ValueSource(strings = {"no-such-controller", "java -version"})
    void aScenarioOpensWithItsOwnControllerIfTheChosenOneCannotBeStarted(String command) {
        runOnEdt(() -> {
            controllers.select(ControllerChoice.of(command));
            store.open(CABLE);
        });
        Await.until(
                "the other scenario",
                () -> workspace.scenario().orElseThrow().name().equals("Cable"));
        assertEquals(List.of(TaskKind.OPEN), callOnEdt(() -> List.copyOf(failures)));
        assertTrue(opensWithoutChoice);
    }

    @Test
    void theScenariosOwnControllerIsOfferedWhileAnotherOneIsChosen() {
        UiAction scenarios = callOnEdt(() -> {
            ActionRegistry actions = new ActionRegistry();
            controllers.addTo(actions);
            return actions.get("scenarioController");
        });
        assertFalse(callOnEdt(scenarios::isEnabled));
        runOnEdt(() -> controllers.tryOut(ControllerChoice.of("none")));
        Await.until("the chosen controller", () -> controllers.chosenText().equals("none"));
        assertTrue(callOnEdt(scenarios::isEnabled));
        runOnEdt(() -> scenarios.actionPerformed(null));
        Await.until("the scenario's controller", () -> controllers.chosenText().isEmpty());
        assertFalse(callOnEdt(scenarios::isEnabled));
    }

    /** Writes a program that never answers. */
    private static Path writeProgram(Path folder) throws IOException {
        return Files.writeString(
                folder.resolve("waiter.sh"),
                "read hello; echo '{\"type\":\"ready\",\"protocol\":1,\"name\":\"waiter\"}'; cat");
    }

    /** The program writes the first message of each run to a file. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the program is a shell script")
    void aProgramReceivesTheNameOfTheScenarioThatItDrives(@TempDir Path folder) throws IOException {
        Path program = Files.writeString(
                folder.resolve("echo.sh"),
                "read hello; echo \"$hello\" >> '" + folder.resolve("hello")
                        + "'; echo '{\"type\":\"ready\",\"protocol\":1}'; cat");
        runOnEdt(() -> {
            controllers.select(ControllerChoice.of("sh " + program));
            store.open(CABLE);
        });
        awaitSession(2);
        runOnEdt(() -> store.open(OFFICE));
        awaitSession(3);
        runOnEdt(() -> run.change(scenario -> scenario.withName("Renamed")));
        runOnEdt(run::restart);
        awaitSession(4);
        List<String> names = new ArrayList<>();
        for (String hello : Files.readAllLines(folder.resolve("hello"))) {
            names.add(hello.replaceAll(".*\"scenario\":\"([^\"]*)\".*", "$1"));
        }
        assertEquals(List.of("Cable", "Office", "Renamed"), names);
    }

    private void awaitSession(int number) {
        Await.until("session " + number, () -> sessions == number);
    }

    /** Drives the robot with a controller; returns when its run or a failure has been shown. */
    private void tryOut(String text) {
        int before = failures.size();
        runOnEdt(() -> controllers.tryOut(ControllerChoice.of(text)));
        Await.until(text, () -> controllers.chosenText().equals(text) || failures.size() > before);
        BackgroundThreads.awaitEnd();
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the program is a shell script")
    void theCommandsThatHaveStartedAControllerAreRemembered(@TempDir Path folder) throws IOException {
        Path program = writeProgram(folder);
        tryOut("sh " + program + " older");
        tryOut("sh " + program + " newer");
        tryOut("none");
        tryOut(MISSING.text());
        assertEquals(List.of(TaskKind.RESTART), callOnEdt(() -> List.copyOf(failures)));
        assertEquals(
                List.of("sh " + program + " newer", "sh " + program + " older"),
                callOnEdt(() -> preferences.recentCommands().texts()));
    }

    /** The program of the ghost starts and gives a wrong answer, after which it can be repaired and tried again. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the program is a shell script")
    void theCommandsThatHaveStartedAGhostAreRemembered(@TempDir Path folder) throws IOException {
        String command = "sh " + writeProgram(folder);
        for (String text : List.of(command, "none", MISSING.text())) {
            int before = callOnEdt(() -> ghosts);
            runOnEdt(() -> {
                controllers.select(ControllerChoice.SCENARIO, ControllerChoice.of(text));
                run.restart();
            });
            Await.until("the end of the ghost", () -> ghosts > before);
            BackgroundThreads.awaitEnd();
        }
        assertEquals(List.of(TaskKind.GHOST, TaskKind.GHOST), callOnEdt(() -> List.copyOf(failures)));
        assertEquals(
                List.of(command), callOnEdt(() -> preferences.recentCommands().texts()));
    }

    /** Moving the run does not bring a command to the top of the list again. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the program is a shell script")
    void aCommandIsRememberedWhenItIsChosenAndNotInEverySession(@TempDir Path folder) throws IOException {
        Path program = writeProgram(folder);
        tryOut("sh " + program);
        runOnEdt(stored::clear);
        runOnEdt(controllers::sessionStarted);
        BackgroundThreads.awaitEnd();
        assertEquals(List.of(), callOnEdt(() -> preferences.recentCommands().texts()));
    }

    /** A command whose program need not run: its file is only watched. */
    @Test
    void aNoteSaysUntilARestartThatAFileOfTheControllerHasChanged(@TempDir Path folder) throws IOException {
        Path program = Files.writeString(folder.resolve("follower.py"), "");
        runOnEdt(() -> {
            controllers.select(ControllerChoice.of(ShellWords.quoted(program.toString())));
            controllers.sessionStarted();
        });
        BackgroundThreads.awaitEnd();
        checkFiles();
        assertEquals(List.of(), keptNotes);
        Files.setLastModifiedTime(program, FileTime.fromMillis(1_000_000));
        checkFiles();
        checkFiles();
        assertEquals(List.of("follower.py has changed; restart the run to load it"), keptNotes);
        runOnEdt(() -> {
            Messages.setLanguage(Language.POLISH);
            controllers.updateTexts();
            Messages.setLanguage(Language.ENGLISH);
        });
        assertEquals(List.of("Plik follower.py się zmienił; uruchom od nowa, aby go wczytać"), keptNotes);
        runOnEdt(controllers::sessionStarted);
        assertEquals(List.of(), keptNotes, "after a restart");
        assertEquals(List.of(), notes);
    }

    /** A build may take seconds from one to the other. */
    @Test
    void aFileThatIsDeletedAndWrittenAgainHasChanged(@TempDir Path folder) throws IOException {
        Path program = Files.writeString(folder.resolve("follower.py"), "");
        runOnEdt(() -> {
            controllers.select(ControllerChoice.of(ShellWords.quoted(program.toString())));
            controllers.sessionStarted();
        });
        BackgroundThreads.awaitEnd();
        Files.delete(program);
        checkFiles();
        assertEquals(List.of(), keptNotes);
        Files.writeString(program, "");
        Files.setLastModifiedTime(program, FileTime.fromMillis(1_000_000));
        checkFiles();
        assertEquals(List.of("follower.py has changed; restart the run to load it"), keptNotes);
    }

    /** The answer of a slow disk to a check from before a restart. */
    @Test
    void theTimesOfTheFilesBeforeARestartAreNoChange(@TempDir Path folder) throws IOException {
        Path program = Files.writeString(folder.resolve("follower.py"), "");
        runOnEdt(() -> {
            controllers.select(ControllerChoice.of(ShellWords.quoted(program.toString())));
            controllers.sessionStarted();
        });
        BackgroundThreads.awaitEnd();
        FileTime before = Files.getLastModifiedTime(program);
        Consumer<Map<Path, FileTime>> check = callOnEdt(controllers::newCheck);
        Files.setLastModifiedTime(program, FileTime.fromMillis(1_000_000));
        runOnEdt(controllers::sessionStarted);
        BackgroundThreads.awaitEnd();
        runOnEdt(() -> check.accept(Map.of(program, before)));
        checkFiles();
        assertEquals(List.of(), keptNotes);
    }

    private void checkFiles() {
        runOnEdt(controllers::checkFiles);
        BackgroundThreads.awaitEnd();
        runOnEdt(() -> {});
    }

    @Test
    void theFilesOfAnEarlierControllerAreNotWatched() {
        runOnEdt(() -> {
            controllers.select(ControllerChoice.of("wall-follower"));
            controllers.sessionStarted();
            controllers.select(ControllerChoice.SCENARIO);
            controllers.sessionStarted();
        });
        BackgroundThreads.awaitEnd();
        assertFalse(callOnEdt(controllers::isWatching));
    }

    /** The times of the files are read in the background, and arrive after the end. */
    @Test
    void noFilesAreWatchedAfterTheEnd() {
        runOnEdt(() -> {
            controllers.select(ControllerChoice.of("wall-follower"));
            controllers.sessionStarted();
            controllers.close();
        });
        BackgroundThreads.awaitEnd();
        assertFalse(callOnEdt(controllers::isWatching));
    }

    @Test
    void aFileThatCannotBeReadIsNotOpenedAgain() {
        runOnEdt(() -> {
            controllers.select(MISSING);
            store.open(Path.of("scenarios/no-such-file.xml"));
        });
        Await.until("the failure", () -> failures.equals(List.of(TaskKind.OPEN)));
        assertFalse(opensWithoutChoice);
    }
}
