package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.edit.EditedRun;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Edits of a run whose thread has died of an error. */
@ExtendWith(EdtChecker.class)
class DeadRunTest {

    @TempDir
    private Path folder;

    private EditedRun dead;
    private Workspace workspace;
    private RunController run;
    private Scenario edited;
    private final List<Throwable> failures = new ArrayList<>();
    /** How often the user has been informed that the run cannot be resumed. */
    private int refusals;

    @BeforeEach
    void editAndDie() throws Exception {
        Path file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("room.xml"));
        dead = new EditedRun(file, new WorkspaceListener() {
            @Override
            public void taskFailed(TaskKind task, Path failed, Throwable failure) {
                failures.add(failure);
            }

            @Override
            public void failedRunResumed() {
                refusals++;
            }
        });
        workspace = dead.workspace();
        run = dead.controller();
        dead.send(new Command.SwitchSensor("left", false));
        edited = dead.scenario();
        killTheRun();
    }

    private void killTheRun() throws InterruptedException {
        CountDownLatch died = new CountDownLatch(1);
        runOnEdt(() -> {
            workspace.session().orElseThrow().setPausedChangeListener(() -> {
                Thread.currentThread().setUncaughtExceptionHandler((thread, error) -> died.countDown());
                throw new OutOfMemoryError("as of a large world");
            });
            run.step();
        });
        died.await();
    }

    @AfterEach
    void close() {
        dead.close();
        assertEquals(List.of(), failures);
    }

    @Test
    void whoResumesOrStepsItIsInformed() {
        runOnEdt(run::toggleRunning);
        assertEquals(1, callOnEdt(() -> refusals));
        runOnEdt(run::step);
        assertEquals(2, callOnEdt(() -> refusals));
    }

    @Test
    void itsEditsCanBeSaved() throws Exception {
        Path copy = folder.resolve("copy.xml");
        runOnEdt(() -> dead.documents().save(copy, () -> {}));
        Await.until("the save", () -> !workspace.isChanged() || !failures.isEmpty());
        assertEquals(edited, Scenario.load(copy));
    }

    @Test
    void itCanBeRestartedWithItsEdits() {
        dead.restart();
        assertEquals(edited, dead.scenario());
        runOnEdt(run::step);
        SessionFrames.awaitTick(workspace, 1);
    }

    @Test
    void commandsAreAnsweredWithoutResults() {
        List<List<CommandResult>> answers = new ArrayList<>();
        runOnEdt(() -> {
            run.send(List.of(new Command.SwitchSensor("front", false)), answers::add);
            assertFalse(workspace.awaitsCommands());
        });
        Await.until("the answer", () -> !answers.isEmpty());
        assertEquals(List.of(List.of()), answers);
        assertEquals(edited, dead.scenario());
    }

    @Test
    void itsUnsavedEditsAreKeptWhenTheWindowCloses() throws IOException {
        RecoveryStore dying = new RecoveryStore(folder.resolve("kept"), Integer.MAX_VALUE, Instant.EPOCH);
        Autosave autosave = callOnEdt(() -> new Autosave(workspace, dying, failures::add));
        runOnEdt(() -> {
            autosave.saveUnsavedEdits();
            autosave.close();
            workspace.close();
        });
        CountDownLatch written = new CountDownLatch(1);
        runOnEdt(() -> BackgroundTasks.runAfterAll(written::countDown));
        Await.until("the end of all writes", () -> written.getCount() == 0);
        assertTrue(dying.findOrphan(Set.of()).isPresent());
    }
}
