package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.edit.EditedRun;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.awt.SecondaryLoop;
import java.awt.Toolkit;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** A file that another program has changed is not replaced before the user has answered the question about it. */
@ExtendWith(EdtChecker.class)
class ForeignChangeTest {

    @TempDir
    private Path folder;

    private Path file;
    private EditedRun edited;
    private Workspace workspace;
    private DocumentStore documentStore;
    /** The answers of the file watch's question: whether the user keeps the open scenario. */
    private final List<Boolean> watchAnswers = new ArrayList<>();

    @BeforeEach
    void editAFileThatAnotherProgramThenChanges() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("room.xml"));
        edited = new EditedRun(file, new TaskFailures());
        workspace = edited.workspace();
        documentStore = edited.documents();
        edited.send(new Command.SwitchSensor("left", false));
        Files.writeString(file, Files.readString(file).replaceFirst("name=\"[^\"]*\"", "name=\"Other\""));
    }

    @AfterEach
    void close() {
        edited.close();
    }

    /** Saves the scenario, and returns the change that is asked about; null if it is saved without a question. */
    private DocumentStore.ForeignChange save() {
        List<DocumentStore.ForeignChange> changes = new ArrayList<>();
        runOnEdt(() -> documentStore.saveUnlessReplaced(() -> changes.add(null), changes::add));
        Await.until("the save or the question", () -> !changes.isEmpty());
        return changes.get(0);
    }

    private void assertSaveIsQuestioned() throws Exception {
        assertNotNull(save(), "saved without a question");
        assertEquals("Other", Scenario.load(file).name());
    }

    /** Lets a watch read the file; its question is answered by whether the user keeps the open scenario. */
    private void watch(boolean keep) {
        Predicate<Path> question = changed -> {
            watchAnswers.add(keep);
            return keep;
        };
        poll(callOnEdt(() -> new FileWatch(workspace, question, broken -> {}, deleted -> {})), 4);
    }

    private static void poll(FileWatch watch, int times) {
        for (int i = 0; i < times; i++) {
            runOnEdt(watch::poll);
            Await.until("the end of a poll", () -> !watch.isPolling());
        }
        runOnEdt(watch::close);
    }

    @Test
    void aSaveAsksUntilItsQuestionIsAnswered() throws Exception {
        assertSaveIsQuestioned();
        // The question is closed.
        DocumentStore.ForeignChange change = save();
        assertEquals("Other", Scenario.load(file).name());
        runOnEdt(change.save()::run);
        Await.until("the save", () -> !workspace.isChanged());
        assertEquals(callOnEdt(workspace::scenario).orElseThrow(), Scenario.load(file));
    }

    @Test
    void theWatchDoesNotAskAfterASaveHasAsked() throws Exception {
        assertSaveIsQuestioned();
        watch(false);
        assertEquals(List.of(), watchAnswers);
        assertSaveIsQuestioned();
    }

    @Test
    void aSaveAsksAfterTheQuestionOfTheWatchWasClosed() throws Exception {
        watch(false);
        assertEquals(List.of(false), watchAnswers);
        assertSaveIsQuestioned();
    }

    @Test
    void aSaveDoesNotAskAfterTheUserHasKeptTheOpenScenario() throws Exception {
        watch(true);
        assertEquals(List.of(true), watchAnswers);
        assertNull(save());
        assertEquals(callOnEdt(workspace::scenario).orElseThrow(), Scenario.load(file));
    }

    @Test
    void aSaveDoesNotAskIfTheFileAlreadyHoldsTheEditedScenario() throws Exception {
        callOnEdt(() -> workspace.scenario().orElseThrow()).save(file);
        assertNull(save());
    }

    /** A restart copies what the file holds to another document. */
    @Test
    void aSaveAsksAgainAfterARestart() throws Exception {
        assertSaveIsQuestioned();
        OpenDocument before = callOnEdt(() -> workspace.openDocument().orElseThrow());
        runOnEdt(() -> new RunController(workspace).restart());
        Await.until("the restart", () -> workspace.openDocument().orElseThrow() != before);
        assertSaveIsQuestioned();
    }

    /** The edits are based on what the file held, not on what the other program has written. */
    @Test
    void aSaveAsksAgainAfterACrash() throws Exception {
        assertSaveIsQuestioned();
        RecoveryStore dying = new RecoveryStore(folder.resolve("kept"), Integer.MAX_VALUE, Instant.EPOCH);
        Autosave autosave = callOnEdt(() -> new Autosave(workspace, dying, failure -> {}));
        runOnEdt(autosave::saveUnsavedEdits);
        Await.until("the kept edits", () -> dying.findOrphan(Set.of()).isPresent());
        OpenDocument before = callOnEdt(() -> workspace.openDocument().orElseThrow());
        RecoveryStore.RecoveredFile kept = dying.findOrphan(Set.of()).orElseThrow();
        runOnEdt(() -> documentStore.recover(kept, () -> {}, () -> {}));
        Await.until("the recovery", () -> workspace.openDocument().orElseThrow() != before);
        assertSaveIsQuestioned();
    }

    /** The file that was chosen before the question opens while the question is shown. */
    @Test
    void theAnswerOfTheWatchDoesNotConcernAScenarioThatIsOpenedMeanwhile() throws Exception {
        Path other = Files.copy(Path.of("scenarios/mirror.xml"), folder.resolve("mirror.xml"));
        Predicate<Path> question = changed -> {
            SecondaryLoop modal =
                    Toolkit.getDefaultToolkit().getSystemEventQueue().createSecondaryLoop();
            documentStore.open(other);
            workspace.addListener(new WorkspaceListener() {
                @Override
                public void taskFinished() {
                    modal.exit();
                }
            });
            modal.enter();
            return watchAnswers.add(true);
        };
        poll(callOnEdt(() -> new FileWatch(workspace, question, broken -> {}, deleted -> {})), 4);
        Await.until("the answer", () -> watchAnswers.size() == 1);
        assertEquals(Optional.of(other), callOnEdt(workspace::file));
        assertEquals(Optional.of(Scenario.load(other)), callOnEdt(workspace::savedScenario));
        assertEquals(Optional.of(Scenario.load(other)), callOnEdt(workspace::replaceableScenario));
        assertFalse(callOnEdt(workspace::isChanged));
    }

    @Test
    void theWatchDoesNotAskWhileAScenarioIsBeingOpened() throws Exception {
        CountDownLatch opened = new CountDownLatch(1);
        Scenario scenario = Scenario.load(Path.of("scenarios/mirror.xml"));
        runOnEdt(() -> documentStore.open(file, () -> {
            opened.await();
            return scenario;
        }));
        watch(true);
        assertEquals(List.of(), watchAnswers);
        opened.countDown();
        Await.until("the scenario", () -> workspace.task().isEmpty());
    }
}
