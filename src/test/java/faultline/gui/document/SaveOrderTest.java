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
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Saves that are requested while others are being written. */
@ExtendWith(EdtChecker.class)
class SaveOrderTest {

    @TempDir
    private Path folder;

    private Path file;
    private Path other;
    private EditedRun edited;
    private Workspace workspace;
    private RunController run;
    private DocumentStore documentStore;
    private final List<Path> saved = Collections.synchronizedList(new ArrayList<>());
    private final List<String> failures = Collections.synchronizedList(new ArrayList<>());
    private final List<BooleanSupplier> slow = Collections.synchronizedList(new ArrayList<>());
    private final List<DocumentStore.ForeignChange> changes = Collections.synchronizedList(new ArrayList<>());

    @BeforeEach
    void editAFile() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("room.xml"));
        other = folder.resolve("other.xml");
        edited = new EditedRun(file, new WorkspaceListener() {
            @Override
            public void scenarioSaved(Path written) {
                saved.add(written);
            }

            @Override
            public void saveSlow(Path written, BooleanSupplier writing) {
                slow.add(writing);
            }

            @Override
            public void taskFailed(TaskKind task, Path written, Throwable failure) {
                failures.add(failure.getMessage());
            }
        });
        workspace = edited.workspace();
        run = edited.controller();
        documentStore = edited.documents();
        rename("Edited");
    }

    @AfterEach
    void close() {
        edited.close();
    }

    private void rename(String name) {
        runOnEdt(() -> run.change(scenario -> scenario.withName(name)));
    }

    private void save() {
        documentStore.saveUnlessReplaced(() -> {}, changes::add);
    }

    private void saveAsOther() {
        documentStore.save(other, () -> {});
    }

    private void awaitSaved(Path... files) {
        Await.until("the saves", () -> saved.size() == files.length);
        assertEquals(List.of(files), saved);
    }

    @Test
    void theFileOfALaterSaveAsIsTheFileOfTheScenario() throws Exception {
        runOnEdt(() -> {
            save();
            saveAsOther();
        });
        awaitSaved(file, other);
        assertEquals(Optional.of(other), callOnEdt(workspace::file));
        rename("Edited later");
        runOnEdt(this::save);
        awaitSaved(file, other, other);
        assertEquals("Edited", Scenario.load(file).name());
        assertEquals("Edited later", Scenario.load(other).name());
    }

    @Test
    void aSaveAfterASaveAsLeavesTheFirstFileAsItIs() throws Exception {
        String before = Files.readString(file);
        runOnEdt(() -> {
            saveAsOther();
            run.change(scenario -> scenario.withName("Edited later"));
            save();
        });
        awaitSaved(other, other);
        assertEquals("Edited later", Scenario.load(other).name());
        assertEquals(before, Files.readString(file));
        assertEquals(Optional.of(other), callOnEdt(workspace::file));
    }

    @Test
    void anotherSaveDoesNotAskAboutWhatTheFirstOneHasWritten() throws Exception {
        runOnEdt(() -> {
            save();
            run.change(scenario -> scenario.withName("Edited later"));
            save();
        });
        awaitSaved(file, file);
        assertEquals(List.of(), changes);
        assertEquals("Edited later", Scenario.load(file).name());
    }

    /** Nobody reads the pipe, so a write to it would not end. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no mkfifo")
    void aPipeIsRefusedAndDoesNotBlockLaterSaves() throws Exception {
        Path pipe = folder.resolve("pipe.xml");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
        runOnEdt(() -> {
            documentStore.save(pipe, () -> {});
            documentStore.saveJournal(pipe);
            save();
        });
        awaitSaved(file);
        String refusal = pipe + ": this is a device or a pipe; expected a file";
        assertEquals(List.of(refusal, refusal), failures);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no mkfifo")
    void aScenarioFromAPipeIsSavedAsAFile() throws Exception {
        Path pipe = folder.resolve("pipe.xml");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
        Scenario scenario = edited.scenario();
        runOnEdt(() -> documentStore.open(pipe, () -> scenario));
        Await.until("the scenario", () -> workspace.file().equals(Optional.of(pipe)));
        runOnEdt(this::saveAsOther);
        awaitSaved(other);
        assertEquals(scenario, Scenario.load(other));
    }

    @Test
    void aSaveThatTakesLongIsReportedUntilItEnds() {
        runOnEdt(() -> {
            workspace.editDeferred();
            save();
        });
        Await.until("the report", () -> slow.size() == 1);
        assertTrue(slow.get(0).getAsBoolean());
        runOnEdt(workspace::deferredEditsSent);
        awaitSaved(file);
        assertFalse(slow.get(0).getAsBoolean());
    }

    /** The question about the change is open while the other file is written. */
    @Test
    void aSaveThatWaitedForAnAnswerDoesNotReplaceTheFileOfALaterSaveAs() throws Exception {
        Files.writeString(file, Files.readString(file).replaceFirst("name=\"[^\"]*\"", "name=\"Other\""));
        runOnEdt(() -> {
            save();
            saveAsOther();
        });
        awaitSaved(other);
        assertEquals(1, changes.size());
        assertEquals("Other", Scenario.load(file).name());
        runOnEdt(changes.get(0).save()::run);
        awaitSaved(other, file);
        assertEquals("Edited", Scenario.load(file).name());
        assertEquals(Optional.of(other), callOnEdt(workspace::file));
        assertFalse(callOnEdt(workspace::isChanged));
    }
}
