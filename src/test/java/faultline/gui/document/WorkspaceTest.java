package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionView;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.awt.EventQueue;
import java.io.IOException;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The workspace on the event dispatch thread, without a window and without a display. */
class WorkspaceTest {

    private static final String OBSTACLE = "pole";
    private static final Pose ELSEWHERE = new Pose(2, 3, 0);

    @TempDir
    private Path folder;

    private Path file;
    private final List<Throwable> failures = new ArrayList<>();
    private final List<Path> saves = new ArrayList<>();
    private final List<Path> journals = new ArrayList<>();
    private int sessionCount;
    private Workspace workspace;
    private RunController run;
    private DocumentStore documentStore;

    @BeforeEach
    void openAFile() throws IOException {
        file = Files.copy(Path.of("scenarios/collision-on-purpose.xml"), folder.resolve("room.xml"));
        workspace = callOnEdt(Workspace::new);
        runOnEdt(() -> workspace.addListener(new WorkspaceListener() {
            @Override
            public void sessionStarted() {
                sessionCount++;
            }

            @Override
            public void scenarioSaved(Path where) {
                saves.add(where);
            }

            @Override
            public void journalSaved(Path where) {
                journals.add(where);
            }

            @Override
            public void titleChanged() {
                assertTrue(EventQueue.isDispatchThread());
            }

            @Override
            public void taskFailed(TaskKind task, Path taskFile, Throwable failure) {
                failures.add(failure);
            }
        }));
        runOnEdt(() -> {
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

    @Test
    void aFileOpensPausedAtTimeZeroAndUnchanged() {
        assertEquals(0, frame().snapshot().tick());
        assertFalse(callOnEdt(
                () -> workspace.session().map(SessionView::status).orElseThrow().running()));
        assertFalse(callOnEdt(workspace::isChanged));
        assertEquals(Optional.of(file), callOnEdt(workspace::file));
    }

    @Test
    void aMovedObstacleIsUnsavedUntilASaveAndLoadsAtItsNewPose() throws ScenarioException {
        move();
        waitFor("the mark", workspace::isChanged);
        runOnEdt(() -> documentStore.save(file, () -> sessionCount = 7));
        waitFor("the save", () -> sessionCount == 7);
        assertFalse(callOnEdt(workspace::isChanged));
        assertEquals(callOnEdt(workspace::scenario), Optional.of(Scenario.load(file)));
        assertEquals(
                ELSEWHERE,
                obstacle(Scenario.load(file).setup().world().obstacles()).pose());
        assertEquals(List.of(file), saves);
    }

    @Test
    void anEditThatTheRunHasNotMadeYetIsAwaited() {
        runOnEdt(() -> {
            assertFalse(workspace.awaitsCommands());
            send(new Command.SwitchSensor("left", false));
            send(new Command.SwitchSensor("no such sensor", false));
            assertTrue(workspace.awaitsCommands());
        });
        waitFor("both results", () -> !workspace.awaitsCommands());
        assertTrue(callOnEdt(workspace::isChanged));
    }

    @Test
    void aSaveKeepsTheCommentsOfTheFileInThatFileAndInAnother() throws IOException {
        Files.writeString(file, Files.readString(file).replace("<robot", "<!-- the robot -->\n  <robot"));
        Path other = folder.resolve("other.xml");
        move();
        waitFor("the mark", workspace::isChanged);
        runOnEdt(() -> documentStore.save(file, () -> documentStore.save(other, () -> sessionCount = 7)));
        waitFor("the saves", () -> sessionCount == 7);
        assertTrue(Files.readString(file).contains("  <!-- the robot -->\n  <robot x="), Files.readString(file));
        assertEquals(Files.readString(file), Files.readString(other));
    }

    @Test
    void anInjectedFaultIsUnsavedUntilASaveWritesItToTheTimeline() throws ScenarioException {
        Command fault = new Command.InjectFault("left", new Fault.Stuck(0.4));
        runOnEdt(() -> {
            run.step();
            send(fault);
        });
        waitFor("the change", workspace::isChanged);
        runOnEdt(() -> documentStore.save(file, () -> sessionCount = 7));
        waitFor("the save", () -> sessionCount == 7);
        assertEquals(List.of(file), saves);
        assertFalse(callOnEdt(workspace::isChanged));
        SimulationSetup saved = Scenario.load(file).setup();
        assertEquals(
                new SimulationSetup.TimedCommand(2 * saved.dt(), fault),
                saved.timeline().get(saved.timeline().size() - 1));
    }

    @Test
    void aRestartKeepsEditsAndRepeatsSwitchesAtTheirTimes() {
        move();
        runOnEdt(() -> {
            send(new Command.SwitchSensor("left", false));
            run.step();
        });
        SessionFrames.awaitTick(workspace, 1);
        // The step begins with the obstacle elsewhere, in a session of its own.
        runOnEdt(run::restart);
        waitFor("the third session", () -> sessionCount == 3);
        assertEquals(0, frame().snapshot().tick());
        assertEquals(ELSEWHERE, obstacle(frame().snapshot().obstacles()).pose());
        assertTrue(frame().snapshot().robot().sensor("left").orElseThrow().on());
        assertTrue(callOnEdt(workspace::isChanged));
        runOnEdt(run::step);
        SessionFrames.awaitFrame(
                workspace,
                "the switch",
                frame -> !frame.snapshot().robot().sensor("left").orElseThrow().on());
    }

    @Test
    void aBrokenFileIsReportedWithItsProblemsAndLeavesTheOldRunUnchanged() throws IOException {
        SessionFrame before = frame();
        Path broken = Files.writeString(folder.resolve("broken.xml"), "<scenario/>");
        runOnEdt(() -> documentStore.open(broken));
        waitFor("the failure", () -> !failures.isEmpty());
        assertInstanceOf(ScenarioException.class, failures.get(0));
        assertSame(before, frame());
        assertEquals(Optional.of(file), callOnEdt(workspace::file));
    }

    @Test
    void aFileThatCannotBeWrittenIsReportedAndTheChangeStaysUnsaved() {
        move();
        waitFor("the mark", workspace::isChanged);
        runOnEdt(() -> documentStore.save(folder.resolve("no/such/folder/room.xml"), () -> sessionCount = 7));
        waitFor("the failure", () -> !failures.isEmpty());
        assertTrue(callOnEdt(workspace::isChanged));
        assertEquals(1, sessionCount);
    }

    @Test
    void twoTogglesDuringASeekLeaveTheRunPaused() throws Exception {
        runOnEdt(() -> {
            run.navigator().seek(2000);
            run.toggleRunning();
            run.toggleRunning();
        });
        waitFor("the moved run", () -> sessionCount == 2 && workspace.task().isEmpty());
        // The journal is answered after the toggles, which were requested before.
        callOnEdt(() -> workspace.openDocument().orElseThrow().session().journal())
                .get();
        assertFalse(callOnEdt(
                () -> workspace.session().map(SessionView::status).orElseThrow().running()));
    }

    @Test
    void aSavedJournalReplaysTheRunToTheBit() throws ScenarioException {
        runOnEdt(() -> {
            run.setSpeed(Double.POSITIVE_INFINITY);
            run.toggleRunning();
        });
        SessionFrames.awaitFrame(
                workspace, "some time", frame -> frame.snapshot().tick() > 50);
        runOnEdt(() -> send(new Command.SetPlatform(0.3, 0.2, 0.5)));
        runOnEdt(run::toggleRunning);
        waitFor("the pause", () -> !workspace
                .session()
                .map(SessionView::status)
                .orElseThrow()
                .running());
        Path journal = folder.resolve("journal.xml");
        runOnEdt(() -> documentStore.saveJournal(journal));
        waitFor("the journal", () -> journals.equals(List.of(journal)));
        SessionFrames.awaitFrame(
                workspace, "the last frame", frame -> frame.snapshot().robot().length() == 0.3);
        String hash = Scenario.load(journal).run().trajectoryHash();
        assertEquals(String.format("%016x", frame().frame().trajectoryHash()), hash);
    }

    @Test
    void ofTwoFilesOpenedAtTheSameTimeTheLaterOneRemainsOpen() throws IOException {
        Path other = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("other.xml"));
        runOnEdt(() -> {
            documentStore.open(file);
            documentStore.open(other);
        });
        waitFor("the other file", () -> workspace.file().equals(Optional.of(other)));
        assertEquals(2, sessionCount);
    }

    /** The question about the change of another program may be open while a scenario opens that was chosen before. */
    @Test
    void aFileThatAnotherProgramHasChangedIsNotOverwrittenWithTheScenarioOpenedMeanwhile() throws Exception {
        move();
        waitFor("the mark", workspace::isChanged);
        Files.writeString(file, Files.readString(file).replaceFirst("name=\"[^\"]*\"", "name=\"Other\""));
        List<Runnable> save = new ArrayList<>();
        Scenario edited = callOnEdt(() -> workspace.scenario().orElseThrow());
        runOnEdt(() -> documentStore.saveUnlessReplaced(() -> sessionCount = 7, change -> save.add(change.save())));
        waitFor("the question", () -> !save.isEmpty());
        Path other = Files.copy(Path.of("scenarios/mirror.xml"), folder.resolve("mirror.xml"));
        runOnEdt(() -> documentStore.open(other));
        waitFor("the other scenario", () -> sessionCount == 2);
        runOnEdt(save.get(0)::run);
        waitFor("the save", () -> sessionCount == 7);
        assertEquals(edited, Scenario.load(file));
        assertEquals(Optional.of(other), callOnEdt(workspace::file));
        assertFalse(callOnEdt(workspace::isChanged));
    }

    @Test
    void anEditMadeDuringASaveRemainsUnsaved() {
        OpenDocument asked = callOnEdt(() -> workspace.openDocument().orElseThrow());
        Scenario initial = callOnEdt(asked.document()::edited);
        move();
        waitFor("the mark", workspace::isChanged);
        Scenario edited = callOnEdt(() -> workspace.scenario().orElseThrow());
        runOnEdt(() -> documentStore.markSaved(asked.document(), file, initial));
        assertTrue(callOnEdt(workspace::isChanged));
        assertEquals(edited, callOnEdt(() -> workspace.scenario().orElseThrow()));
    }

    @Test
    void aScenarioSavedAsAnotherFileDuringARestartKeepsThatFile() {
        Path other = folder.resolve("other.xml");
        CompletableFuture<OpenDocument> made = new CompletableFuture<>();
        runOnEdt(() -> {
            OpenDocument now = workspace.openDocument().orElseThrow();
            workspace.start(new WorkspaceTask(TaskKind.RESTART, file), made::get);
            documentStore.markSaved(now.document(), other, now.document().edited());
            made.complete(OpenDocument.start(now.document(), workspace));
        });
        waitFor("the second session", () -> sessionCount == 2);
        assertEquals(Optional.of(other), callOnEdt(workspace::file));
        assertFalse(callOnEdt(workspace::isChanged));
    }

    @Test
    void aSaveThatEndsAfterARestartIsThatOfTheRestartedScenario() {
        Path other = folder.resolve("other.xml");
        move();
        waitFor("the mark", workspace::isChanged);
        runOnEdt(() -> {
            OpenDocument before = workspace.openDocument().orElseThrow();
            Scenario edited = before.document().edited();
            workspace.addListener(new WorkspaceListener() {
                @Override
                public void scenarioRestarted(SimulationSetup setup) {
                    documentStore.markSaved(before.document(), other, edited);
                }
            });
            run.restart();
        });
        waitFor("the second session", () -> sessionCount == 2);
        assertEquals(Optional.of(other), callOnEdt(workspace::file));
        assertFalse(callOnEdt(workspace::isChanged));
    }

    @Test
    void aPendingSessionNeverStartsOnceTheWorkspaceIsClosed() {
        CompletableFuture<Void> begun = new CompletableFuture<>();
        CompletableFuture<Void> closed = new CompletableFuture<>();
        CompletableFuture<OpenDocument> made = new CompletableFuture<>();
        runOnEdt(() -> {
            ScenarioDocument document = workspace.openDocument().orElseThrow().document();
            workspace.start(new WorkspaceTask(TaskKind.OPEN, file), () -> {
                begun.complete(null);
                closed.join();
                made.complete(OpenDocument.start(document, workspace));
                return made.join();
            });
        });
        begun.join();
        runOnEdt(workspace::close);
        closed.complete(null);
        Await.until(
                "the end of a session that nobody wants",
                () -> made.isDone() && made.join().session().journal().isCompletedExceptionally());
        assertEquals(1, sessionCount);
        assertEquals(Optional.empty(), callOnEdt(workspace::file));
    }

    /** Work that was started before, such as that of a batch, may want to open a run. */
    @Test
    void nothingIsOpenedOnceTheWorkspaceIsClosed() {
        runOnEdt(() -> {
            workspace.close();
            documentStore.open(file);
            assertEquals(Optional.empty(), workspace.task());
        });
    }

    @Test
    void aRunIsFreeWhenItHasBeenRestarted() {
        WeakReference<Object> before = callOnEdt(
                () -> new WeakReference<>(workspace.openDocument().orElseThrow().session()));
        runOnEdt(run::restart);
        waitFor("the second session", () -> sessionCount == 2);
        Await.until("the end of the first one", () -> {
            System.gc();
            return before.get() == null;
        });
    }

    @Test
    void deferredRequestsAreDiscardedWhenAnotherScenarioIsOpened() throws IOException {
        Path other = Files.copy(file, folder.resolve("other.xml"));
        runOnEdt(() -> {
            run.restart();
            send(new Command.MoveObstacle(OBSTACLE, ELSEWHERE));
            documentStore.open(other);
        });
        waitFor("the other file", () -> workspace.file().equals(Optional.of(other)));
        runOnEdt(run::step);
        SessionFrames.awaitTick(workspace, 1);
        assertFalse(obstacle(frame().snapshot().obstacles()).pose().equals(ELSEWHERE));
    }

    private void send(Command command) {
        run.send(List.of(command), results -> {});
    }

    private void move() {
        runOnEdt(() -> send(new Command.MoveObstacle(OBSTACLE, ELSEWHERE)));
    }

    private SessionFrame frame() {
        return SessionFrames.frame(workspace);
    }

    private static Obstacle obstacle(List<Obstacle> obstacles) {
        return obstacles.stream()
                .filter(obstacle -> obstacle.id().equals(OBSTACLE))
                .findFirst()
                .orElseThrow();
    }

    private void waitFor(String what, Callable<Boolean> condition) {
        Await.until(what, () -> {
            SessionFrames.poll(workspace);
            return condition.call();
        });
    }
}
