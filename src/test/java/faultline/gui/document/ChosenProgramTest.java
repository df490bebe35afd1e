package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.engine.recording.HashTrace;
import faultline.engine.session.ReferenceRun;
import faultline.external.ControllerChoice;
import faultline.external.ExternalController;
import faultline.external.ProcessControllerSource;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.change.Rename;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Another program drives the robot of an open scenario, which does not change. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
class ChosenProgramTest {

    private static final String FOLLOWER =
            """
            read hello
            echo '{"type":"ready","protocol":1,"name":"circle"}'
            i=0
            while read line; do
              case $line in *observe*) echo "{\\"type\\":\\"drive\\",\\"tick\\":$i,\\"v_m_s\\":0.1,\\"omega_rad_s\\":1,\\"state\\":\\"STATE\\"}";; esac
              i=$((i+1))
            done
            """;

    @TempDir
    private Path folder;

    private final List<Throwable> failures = new ArrayList<>();
    private final List<TaskKind> failedTasks = new ArrayList<>();
    private final List<Path> journals = new ArrayList<>();
    private final List<Double> differences = new ArrayList<>();
    private int sessionCount;
    private Workspace workspace;
    private RunController run;
    private DocumentStore documentStore;

    @BeforeEach
    void open() throws IOException {
        Path file = Files.copy(Path.of("scenarios/yard.xml"), folder.resolve("room.xml"));
        workspace = callOnEdt(Workspace::new);
        runOnEdt(() -> {
            workspace.addListener(new WorkspaceListener() {
                @Override
                public void sessionStarted() {
                    sessionCount++;
                }

                @Override
                public void decidedDifferently(double time) {
                    differences.add(time);
                }

                @Override
                public void journalSaved(Path where) {
                    journals.add(where);
                }

                @Override
                public void taskFailed(TaskKind task, Path taskFile, Throwable failure) {
                    failures.add(failure);
                    failedTasks.add(task);
                }
            });
            run = new RunController(workspace);
            documentStore = new DocumentStore(workspace);
            documentStore.open(file);
        });
        waitFor("the first session", () -> sessionCount == 1);
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    private static void waitFor(String what, Callable<Boolean> condition) {
        Await.until(what, condition);
    }

    private void choose(String command) {
        ProcessControllerSource.ChildSettings settings = new ProcessControllerSource.ChildSettings(
                "test", "Yard", ExternalController.Timeouts.DEFAULT, false, line -> {});
        runOnEdt(() -> {
            workspace.setControllerChoice((setup, name) ->
                    ControllerChoice.of(command).applyTo(setup, new ProcessControllerSource(command, settings)));
            run.restart();
        });
    }

    private Path script(String state) throws IOException {
        return Files.writeString(folder.resolve("follower.sh"), FOLLOWER.replace("STATE", state));
    }

    private String state() {
        return SessionFrames.frame(workspace).frame().telemetry().state().name();
    }

    private boolean keepsController() {
        return callOnEdt(() -> workspace.keepsController());
    }

    private long tick() {
        return SessionFrames.tick(workspace);
    }

    @Test
    void anotherProgramDrivesAndItsStateIsShown() throws Exception {
        choose("sh " + script("CIRCLE"));
        waitFor("the second session", () -> sessionCount == 2);
        assertEquals("circle", SessionFrames.frame(workspace).controllerName());
        runOnEdt(run::step);
        Await.until("its state", () -> state().equals("CIRCLE"));
        assertFalse(callOnEdt(workspace::isChanged), "the scenario is as it was");
        assertInstanceOf(
                ControllerSpec.WallFollowing.class,
                callOnEdt(() -> workspace.scenario().orElseThrow().setup().controller()));
    }

    @Test
    void aRestartLoadsAChangedProgram() throws Exception {
        choose("sh " + script("OLD"));
        waitFor("the second session", () -> sessionCount == 2);
        script("NEW");
        runOnEdt(run::restart);
        waitFor("the third session", () -> sessionCount == 3);
        runOnEdt(run::step);
        Await.until("its state", () -> state().equals("NEW"));
    }

    @Test
    void aStepBackAndASavedJournalGiveTheSameRun() throws Exception {
        choose("sh " + script("CIRCLE"));
        waitFor("the second session", () -> sessionCount == 2);
        runOnEdt(() -> run.navigator().seek(150));
        waitFor("the third session", () -> sessionCount == 3);
        assertEquals(150, tick());
        long hash = SessionFrames.trajectoryHash(workspace);
        runOnEdt(() -> run.navigator().seek(100));
        waitFor("the fourth session", () -> sessionCount == 4);
        runOnEdt(() -> run.navigator().seek(150));
        waitFor("the fifth session", () -> sessionCount == 5);
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
        Path journal = folder.resolve("journal.xml");
        runOnEdt(() -> documentStore.saveJournal(journal));
        waitFor("the journal", () -> journals.equals(List.of(journal)));
        RunResult replayed = HeadlessRun.run(Scenario.load(journal).setup(), ControllerMode.DIRECT, List.of());
        assertEquals(150, replayed.ticks());
        assertEquals(hash, replayed.trajectoryHash());
    }

    @Test
    void aGhostIsTheRunAsItWasThoughTheProgramHasChanged() throws Exception {
        Path script = script("CIRCLE");
        ComparisonController comparison = callOnEdt(() -> new ComparisonController(workspace, run.navigator()));
        choose("sh " + script);
        waitFor("the second session", () -> sessionCount == 2);
        runOnEdt(() -> run.navigator().seek(30));
        waitFor("the third session", () -> sessionCount == 3);
        HashTrace hashes = SessionFrames.frame(workspace).recording().hashTrace();
        Files.writeString(script, Files.readString(script).replace("0.1", "0.3"));
        runOnEdt(comparison::captureCurrentRun);
        waitFor("the ghost", () -> comparison.pending().isEmpty());
        ReferenceRun ghost = callOnEdt(() -> SessionFrames.poll(workspace)
                .flatMap(comparison::update)
                .orElseThrow()
                .run());
        assertEquals(30, ghost.lastTick());
        assertEquals(OptionalLong.empty(), ghost.hashTrace().firstDifference(hashes, 0));
    }

    @Test
    void aSavedRunKeepsItsControllerUnlessAnotherOneIsChosenForIt() throws Exception {
        choose("sh " + script("CIRCLE"));
        waitFor("the second session", () -> sessionCount == 2);
        runOnEdt(() -> run.navigator().seek(50));
        waitFor("the third session", () -> sessionCount == 3);
        long hash = SessionFrames.trajectoryHash(workspace);
        Path journal = folder.resolve("journal.xml");
        runOnEdt(() -> documentStore.saveJournal(journal));
        waitFor("the journal", () -> journals.equals(List.of(journal)));
        Path changed = Files.writeString(
                script("FAST"), FOLLOWER.replace("STATE", "FAST").replace("0.1", "0.3"));
        runOnEdt(() -> documentStore.open(journal));
        waitFor("the saved run", () -> sessionCount == 4);
        assertTrue(keepsController());
        runOnEdt(() -> run.navigator().seek(50));
        waitFor("its end", () -> sessionCount == 5);
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
        runOnEdt(run::restart);
        waitFor("a restart", () -> sessionCount == 6);
        assertTrue(keepsController());
        choose("sh " + changed);
        waitFor("the run with another controller", () -> sessionCount == 7);
        assertFalse(keepsController());
        runOnEdt(() -> run.navigator().seek(50));
        waitFor("its tick 50", () -> sessionCount == 8);
        assertEquals("FAST", state());
        assertNotEquals(hash, SessionFrames.trajectoryHash(workspace));
    }

    @Test
    void aMoveOfTheRunReportsThatAChangedProgramHasDecidedDifferently() throws Exception {
        choose("sh " + script("CIRCLE"));
        waitFor("the second session", () -> sessionCount == 2);
        runOnEdt(() -> run.navigator().seek(30));
        waitFor("the third session", () -> sessionCount == 3);
        runOnEdt(() -> run.navigator().seek(20));
        waitFor("the fourth session", () -> sessionCount == 4);
        Files.writeString(folder.resolve("follower.sh"), FOLLOWER.replace("0.1", "0.3"));
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(differences)), "the same program");
        runOnEdt(() -> run.navigator().seek(10));
        waitFor("the report", () -> !differences.isEmpty());
        assertEquals(List.of(0.01), callOnEdt(() -> List.copyOf(differences)));
        runOnEdt(() -> run.navigator().seek(15));
        waitFor("the sixth session", () -> sessionCount == 6);
        assertEquals(1, callOnEdt(differences::size), "the changed program again");
    }

    private void moveTheTreeInARunOfAProgram() throws Exception {
        choose("sh " + script("CIRCLE"));
        waitFor("the second session", () -> sessionCount == 2);
        runOnEdt(() -> {
            run.send(List.of(new Command.MoveObstacle("tree", new Pose(9, 2.5, 0))), results -> {});
            run.step();
        });
        Await.until("the move", () -> tick() == 1 && workspace.isChanged());
    }

    @Test
    void aNewIdOfAnObstacleReportsThatAChangedProgramHasDecidedDifferently() throws Exception {
        moveTheTreeInARunOfAProgram();
        runOnEdt(() -> run.rename(Rename.ofObstacle("tree", "oak")));
        waitFor("the third session", () -> sessionCount == 3);
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(differences)), "the same program");
        Files.writeString(folder.resolve("follower.sh"), FOLLOWER.replace("0.1", "0.3"));
        runOnEdt(() -> run.rename(Rename.ofObstacle("oak", "tree")));
        waitFor("the report", () -> !differences.isEmpty());
        assertEquals(List.of(0.01), callOnEdt(() -> List.copyOf(differences)));
    }

    @Test
    void aNewIdOfAnObstacleThatTheProgramDoesNotSurviveLeavesTheRunAsItIs() throws Exception {
        Path script = script("CIRCLE");
        choose("sh " + script);
        waitFor("the second session", () -> sessionCount == 2);
        runOnEdt(() -> run.navigator().seek(30));
        waitFor("the third session", () -> sessionCount == 3);
        long hash = SessionFrames.trajectoryHash(workspace);
        Files.writeString(script, "exit 1");
        runOnEdt(() -> run.rename(Rename.ofObstacle("tree", "oak")));
        waitFor("the failure", () -> failedTasks.equals(List.of(TaskKind.RESIMULATE)));
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
        assertEquals(30, tick());
        assertTrue(callOnEdt(() -> workspace.takeRenames()).isEmpty(), "the run has the id from before");
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(differences)));
        runOnEdt(run::step);
        Await.until("the program of the run before", () -> tick() == 31 && state().equals("CIRCLE"));
    }

    /** The setup without the obstacle drops the move of it; then the setup is that of the run again. */
    @Test
    void aRunWithFewerCommandsThanBeforeIsNoOtherDecision() throws Exception {
        Scenario original = callOnEdt(() -> workspace.scenario().orElseThrow());
        WorldSpec world = original.setup().world();
        moveTheTreeInARunOfAProgram();
        Files.writeString(folder.resolve("follower.sh"), FOLLOWER.replace("0.1", "0.3"));
        runOnEdt(() -> {
            run.change(now -> now.withSetup(now.setup().withWorld(world.withObstacles(List.of()))));
            run.change(now -> original);
        });
        waitFor("the third session", () -> sessionCount == 3);
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(failures)));
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(differences)));
    }

    @Test
    void aProgramThatIsNotThereLeavesTheRunAsItIs() {
        choose("no-such-program");
        waitFor("the failure", () -> !failures.isEmpty());
        assertInstanceOf(RunFailedException.class, failures.get(0));
        assertTrue(failures.get(0).getMessage().contains("no-such-program"), failures.get(0)::getMessage);
        assertEquals(1, callOnEdt(() -> sessionCount));
    }

    @Test
    void aChangeAndAMoveThatTheProgramDoesNotSurviveAreDifferentFailures() throws Exception {
        Path script = script("CIRCLE");
        choose("sh " + script);
        waitFor("the second session", () -> sessionCount == 2);
        runOnEdt(() -> run.navigator().seek(10));
        waitFor("the third session", () -> sessionCount == 3);
        Files.writeString(script, "exit 1");
        runOnEdt(() -> run.navigator().seek(5));
        waitFor("the failure of the move", () -> failedTasks.size() == 1);
        runOnEdt(() ->
                run.change(now -> now.withSetup(now.setup().withSeed(now.setup().seed() + 1))));
        waitFor("the failure of the change", () -> failedTasks.size() == 2);
        assertEquals(List.of(TaskKind.GO_TO, TaskKind.RESIMULATE), callOnEdt(() -> List.copyOf(failedTasks)));
    }
}
