package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.BackgroundThreads;
import faultline.gui.edit.EditedRun;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Edits after a crash, after they are discarded, and when another program writes the file. */
class CrashRecoveryTest {

    /** No process has this id. */
    private static final long DEAD = Integer.MAX_VALUE - 7;

    private static final Pose ELSEWHERE = new Pose(2, 3, 0);

    @TempDir
    private Path folder;

    private Path file;
    private EditedRun edited;
    private Workspace workspace;
    private RunController run;
    private DocumentStore documentStore;
    private final List<Path> changedFiles = new ArrayList<>();
    private final List<ScenarioException> broken = new ArrayList<>();
    private final List<Path> deleted = new ArrayList<>();
    /** The failures of recovery files that would be shown. */
    private final List<Throwable> failures = new ArrayList<>();

    @BeforeEach
    void openAFile() throws IOException {
        file = Files.copy(Path.of("scenarios/collision-on-purpose.xml"), folder.resolve("room.xml"));
        edited = new EditedRun(file, new TaskFailures());
        workspace = edited.workspace();
        run = edited.controller();
        documentStore = edited.documents();
    }

    @AfterEach
    void close() {
        edited.close();
    }

    @Test
    void unsavedEditsSurviveACrashAndRemainUnsaved() throws Exception {
        edit();
        Scenario edited = callOnEdt(() -> workspace.scenario().orElseThrow());
        RecoveryStore dying = new RecoveryStore(folder.resolve("kept"), DEAD, Instant.EPOCH);
        autosave(dying);
        Await.until("the kept edits", () -> dying.findOrphan(Set.of()).isPresent());
        RecoveryStore.RecoveredFile recovered =
                new RecoveryStore(folder.resolve("kept")).findOrphan(Set.of()).orElseThrow();
        assertEquals(Optional.of(file.toAbsolutePath()), recovered.origin());
        assertEquals(edited, recovered.scenario());
        assertEquals(Files.getLastModifiedTime(recovered.recoveryFile()).toInstant(), recovered.written());
        runOnEdt(() -> documentStore.open(file));
        Await.until("the file without the edits", () -> !workspace.scenario().equals(Optional.of(edited)));
        runOnEdt(() -> documentStore.recover(recovered, () -> {}, () -> {}));
        Await.until("the edits", () -> workspace.scenario().equals(Optional.of(edited)));
        assertTrue(callOnEdt(workspace::isChanged));
        assertEquals(
                Optional.of(Scenario.load(file)),
                callOnEdt(workspace::savedScenario),
                "what the file holds is known, so nobody has changed it");
        assertEquals(recovered.origin(), callOnEdt(workspace::file));
    }

    /** The recovered edits are those of an older version of the file. */
    @Test
    void recoveredEditsAreNotSavedOverALaterChangeOfTheFile() throws Exception {
        edit();
        RecoveryStore dying = new RecoveryStore(folder.resolve("kept"), DEAD, Instant.EPOCH);
        autosave(dying);
        Await.until("the kept edits", () -> dying.findOrphan(Set.of()).isPresent());
        Files.writeString(file, Files.readString(file).replaceFirst("name=\"[^\"]*\"", "name=\"Other\""));
        RecoveryStore.RecoveredFile recovered = dying.findOrphan(Set.of()).orElseThrow();
        runOnEdt(() -> documentStore.recover(recovered, () -> {}, () -> {}));
        Await.until("the edits", () -> workspace.file().equals(Optional.of(file.toAbsolutePath())));
        assertSaveIsQuestioned(change -> assertNull(change.problem()));
        assertEquals("Other", Scenario.load(file).name());
    }

    private void assertSaveIsQuestioned(Consumer<DocumentStore.ForeignChange> check) {
        List<DocumentStore.ForeignChange> changes = new ArrayList<>();
        List<Path> saved = new ArrayList<>();
        runOnEdt(() -> documentStore.saveUnlessReplaced(() -> saved.add(file), changes::add));
        Await.until("the answer", () -> !saved.isEmpty() || !changes.isEmpty());
        assertEquals(List.of(), saved);
        check.accept(changes.get(0));
    }

    @Test
    void aFileThatAnotherProgramHasMadeInvalidIsNotReplacedWithoutAQuestion() throws IOException {
        edit();
        Files.writeString(file, "<scenario");
        assertSaveIsQuestioned(change -> assertNotNull(change.problem()));
        assertSaveIsQuestioned(change -> assertNotNull(change.problem()));
        assertEquals("<scenario", Files.readString(file));
    }

    @Test
    void aDeletedFileIsSavedAgainUnlessAnotherProgramHasWrittenAnotherOneInItsPlace() throws Exception {
        edit();
        FileWatch watch = watch(() -> false);
        String whole = Files.readString(file);
        Files.delete(file);
        poll(watch, 4);
        assertEquals(List.of(file), deleted);
        Files.writeString(file, whole.replaceFirst("name=\"[^\"]*\"", "name=\"Other\""));
        assertSaveIsQuestioned(change -> assertNull(change.problem()));
        Files.delete(file);
        AtomicInteger saved = new AtomicInteger();
        runOnEdt(() -> documentStore.saveUnlessReplaced(saved::incrementAndGet, change -> saved.set(-1)));
        Await.until("the save", () -> saved.get() != 0);
        assertEquals(1, saved.get());
    }

    /** The timer saves nothing before the question is answered, so it has seen no edits. */
    @Test
    void theRecoveryFileOfRecoveredEditsIsDeletedWhenTheyAreSaved() throws IOException {
        edit();
        Path kept = folder.resolve("kept");
        new RecoveryStore(kept, DEAD, Instant.EPOCH)
                .save(file, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        runOnEdt(() -> documentStore.open(file));
        Await.until("the file without the edits", () -> !workspace.isChanged());
        RecoveryStore own = new RecoveryStore(kept, DEAD - 1, Instant.EPOCH);
        Autosave autosave = autosave(own);
        runOnEdt(() -> RecoveryPrompt.offerRecovery(
                own,
                autosave,
                (found, onAnswer) ->
                        documentStore.recover(found, () -> onAnswer.accept(RecoveryPrompt.Answer.RECOVER), () -> {}),
                others -> {},
                () -> {}));
        Path ownFile = kept.resolve((DEAD - 1) + "-0.xml");
        Await.until("the edits", () -> workspace.isChanged() && Files.exists(ownFile));
        Await.until("the note of the adoption", autosave::hasEdits);
        runOnEdt(() -> documentStore.save(file, () -> {}));
        Await.until("an empty folder", () -> recoveryFiles().isEmpty());
    }

    @Test
    void theEditsOfAWindowThatStillRunsAreNotOffered() throws IOException {
        RecoveryStore own = new RecoveryStore(folder.resolve("kept"));
        own.save(null, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        assertEquals(Optional.empty(), own.findOrphan(Set.of()));
    }

    @Test
    void editsOfADeadProcessWhoseIdWasReusedAreOfferedUntilAnswered() throws IOException {
        RecoveryStore before = new RecoveryStore(
                folder.resolve("kept"), ProcessHandle.current().pid(), Instant.EPOCH);
        before.save(file, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        RecoveryStore own = new RecoveryStore(folder.resolve("kept"));
        own.save(null, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        own.delete();
        RecoveryStore.RecoveredFile recovered = own.findOrphan(Set.of()).orElseThrow();
        assertEquals(Optional.of(file.toAbsolutePath()), recovered.origin());
        own.adopt(recovered);
        assertEquals(Optional.empty(), own.findOrphan(Set.of()));
        assertEquals(4, recoveryFiles().size(), "they are this process's own now: " + recoveryFiles());
    }

    @Test
    void aDamagedOriginFileHidesNoOtherEdits() throws IOException {
        Path kept = folder.resolve("kept");
        RecoveryStore first = new RecoveryStore(kept, DEAD - 1, Instant.EPOCH);
        first.save(file, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        Path origin = kept.resolve((DEAD - 1) + "-0.origin");
        for (String damage : List.of("\0", "")) {
            Files.writeString(origin, damage);
            assertEquals(
                    Optional.empty(), first.findOrphan(Set.of()).orElseThrow().origin());
        }
        Files.write(origin, new byte[] {(byte) 0xff});
        assertEquals(Optional.empty(), first.findOrphan(Set.of()).orElseThrow().origin());
        Files.delete(origin);
        assertEquals(Optional.empty(), first.findOrphan(Set.of()).orElseThrow().origin());
        Files.writeString(kept.resolve((DEAD - 1) + "-0.xml"), "damaged too");
        new RecoveryStore(kept, DEAD, Instant.EPOCH)
                .save(file, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        assertEquals(
                Optional.of(file.toAbsolutePath()),
                first.findOrphan(Set.of()).orElseThrow().origin());
    }

    @Test
    void theEditsOfAProcessThatIsNotVisibleHereAreNotOfferedWhileItRuns() throws Exception {
        Path kept = folder.resolve("kept");
        new RecoveryStore(kept, DEAD, Instant.EPOCH)
                .save(file, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        Path lock = Files.createFile(kept.resolve(DEAD + "-0.lock"));
        RecoveryStore own = new RecoveryStore(kept);
        try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE)) {
            channel.lock();
            assertEquals(Optional.empty(), own.findOrphan(Set.of()));
        }
        assertTrue(own.findOrphan(Set.of()).isPresent());
    }

    @Test
    void editsAreOfferedByOneWindowAtATime() throws Exception {
        Path kept = folder.resolve("kept");
        new RecoveryStore(kept, DEAD, Instant.EPOCH)
                .save(file, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        RecoveryStore first = new RecoveryStore(kept);
        RecoveryStore second = new RecoveryStore(kept);
        assertTrue(first.findOrphan(Set.of()).isPresent());
        assertEquals(Optional.empty(), second.findOrphan(Set.of()));
        first.release();
        RecoveryStore.RecoveredFile found = second.findOrphan(Set.of()).orElseThrow();
        assertEquals(Optional.empty(), first.findOrphan(Set.of()));
        second.discard(found);
        assertEquals(Optional.empty(), first.findOrphan(Set.of()));
        assertEquals(List.of(), recoveryFiles());
    }

    @Test
    void editsThatTheUserWantsLaterAreOfferedByTheNextWindow() throws Exception {
        Path kept = folder.resolve("kept");
        new RecoveryStore(kept, DEAD, Instant.EPOCH)
                .save(file, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        RecoveryStore first = new RecoveryStore(kept);
        RecoveryStore second = new RecoveryStore(kept);
        Autosave autosave = callOnEdt(() -> new Autosave(workspace, first, failures::add));
        AtomicReference<Boolean> foundDuringTheOffer = new AtomicReference<>();
        runOnEdt(() -> RecoveryPrompt.offerRecovery(
                first,
                autosave,
                (found, onAnswer) -> {
                    foundDuringTheOffer.set(isFoundBy(second));
                    onAnswer.accept(RecoveryPrompt.Answer.LATER);
                },
                others -> {},
                () -> {}));
        Await.until("the answer", () -> foundDuringTheOffer.get() != null);
        Await.until("the offer of the next window", () -> isFoundBy(second));
        assertFalse(foundDuringTheOffer.get());
    }

    private static boolean isFoundBy(RecoveryStore store) {
        try {
            return store.findOrphan(Set.of()).isPresent();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String permissions(Path file) {
        try {
            return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void onlyTheOwnerMayReadTheRecoveryFiles() throws IOException {
        new RecoveryStore(folder.resolve("home/.faultline/recovery"))
                .save(file, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        for (String name : List.of("home/.faultline", "home/.faultline/recovery")) {
            assertEquals("rwx------", permissions(folder.resolve(name)));
        }
        try (Stream<Path> files = Files.list(folder.resolve("home/.faultline/recovery"))) {
            assertEquals(
                    List.of("rw-------", "rw-------", "rw-------"),
                    files.filter(path -> !path.toString().endsWith(".lock"))
                            .map(CrashRecoveryTest::permissions)
                            .toList());
        }
    }

    private List<Path> recoveryFiles() throws IOException {
        try (Stream<Path> kept = Files.list(folder.resolve("kept"))) {
            return kept.toList();
        }
    }

    @Test
    void aFailedAutosaveIsReportedOnceAndRetried() throws IOException {
        RecoveryStore dying = new RecoveryStore(folder.resolve("kept"), DEAD, Instant.EPOCH);
        Path obstacle = Files.createFile(folder.resolve("kept"));
        AtomicInteger failed = new AtomicInteger();
        AtomicBoolean printed = new AtomicBoolean();
        Logger log = Logger.getLogger(Autosave.class.getName());
        log.setLevel(Level.FINE);
        log.setFilter(record -> {
            failed.incrementAndGet();
            printed.set(printed.get() || record.getLevel().intValue() > Level.FINE.intValue());
            return false;
        });
        edit();
        Autosave autosave = autosave(dying);
        Await.until("the first failure", () -> failed.get() == 1);
        runOnEdt(autosave::saveUnsavedEdits);
        Await.until("the second failure", () -> failed.get() == 2);
        log.setFilter(null);
        log.setLevel(null);
        assertFalse(printed.get(), "the window says it");
        assertEquals(1, callOnEdt(failures::size));
        Files.delete(obstacle);
        runOnEdt(autosave::saveUnsavedEdits);
        Await.until("the kept edits", () -> dying.findOrphan(Set.of()).isPresent());
        assertEquals(1, callOnEdt(failures::size));
    }

    /** Before the edits, the folder was already a file: there was nothing to be kept. */
    @Test
    void theFirstEditsThatCannotBeKeptAreReported() throws IOException {
        Path obstacle = Files.createFile(folder.resolve("kept"));
        RecoveryStore store = new RecoveryStore(obstacle.resolve("recovery"), DEAD, Instant.EPOCH);
        AtomicInteger failed = new AtomicInteger();
        AtomicBoolean printed = new AtomicBoolean();
        Logger log = Logger.getLogger(Autosave.class.getName());
        log.setLevel(Level.FINE);
        log.setFilter(record -> {
            failed.incrementAndGet();
            printed.set(printed.get() || record.getLevel().intValue() > Level.FINE.intValue());
            return false;
        });
        Autosave autosave = autosave(store);
        Await.until("the failure without edits", () -> failed.get() == 1);
        assertEquals(List.of(), failures);
        assertFalse(callOnEdt(autosave::isFailing));
        edit();
        runOnEdt(autosave::saveUnsavedEdits);
        Await.until("the failure with edits", () -> failed.get() == 2);
        assertEquals(1, callOnEdt(failures::size));
        assertTrue(callOnEdt(autosave::isFailing));
        runOnEdt(() -> documentStore.save(file, () -> {}));
        Await.until("the save", () -> failed.get() == 3);
        log.setFilter(null);
        log.setLevel(null);
        assertFalse(printed.get(), "the window says it");
        assertFalse(callOnEdt(autosave::isFailing));
        assertEquals(1, callOnEdt(failures::size));
        Files.delete(obstacle);
    }

    @Test
    void theRecoveryFileOfSavedEditsIsDeletedAtOnce() {
        RecoveryStore dying = new RecoveryStore(folder.resolve("kept"), DEAD, Instant.EPOCH);
        edit();
        long written = System.nanoTime();
        autosave(dying);
        Await.until("the kept edits", () -> dying.findOrphan(Set.of()).isPresent());
        runOnEdt(() -> documentStore.save(file, () -> {}));
        Await.until("nothing to be kept", () -> dying.findOrphan(Set.of()).isEmpty());
        assertTrue(System.nanoTime() - written < Autosave.PERIOD_MILLIS * 1_000_000L, "not by the timer");
    }

    @Test
    void aWindowThatClosesNormallyLeavesNoRecoveryFile() throws IOException {
        RecoveryStore dying = new RecoveryStore(folder.resolve("kept"), DEAD, Instant.EPOCH);
        edit();
        Autosave autosave = autosave(dying);
        Await.until("the kept edits", () -> dying.findOrphan(Set.of()).isPresent());
        runOnEdt(autosave::close);
        Await.until("an empty folder", () -> recoveryFiles().isEmpty());
        autosave.write(null, null, callOnEdt(() -> workspace.scenario().orElseThrow()));
        assertEquals(List.of(), recoveryFiles());
    }

    @Test
    void revertingDiscardsEdits() {
        Scenario before = callOnEdt(() -> workspace.scenario().orElseThrow());
        edit();
        runOnEdt(documentStore::revert);
        Await.until("the scenario as it was", () -> workspace.scenario().equals(Optional.of(before)));
        assertFalse(callOnEdt(workspace::isChanged));
    }

    @Test
    void anotherScenarioInTheFileIsReportedOnce() throws IOException {
        FileWatch watch = watch(() -> false);
        poll(watch, 3);
        assertEquals(List.of(), changedFiles);
        rewrite(Files.readString(file)
                .replaceFirst("seed=\"\\d+\"", "")
                .replaceFirst("<scenario ", "<scenario seed=\"4711\" "));
        poll(watch, 1);
        assertEquals(List.of(), changedFiles, "the file may still be growing");
        poll(watch, 4);
        assertEquals(List.of(file), changedFiles);
    }

    /** The dialog shows values of the scenario that the user may choose to replace. */
    @Test
    void nothingIsReportedWhileADialogIsOpen() throws IOException {
        AtomicBoolean dialogOpen = new AtomicBoolean(true);
        FileWatch watch = watch(dialogOpen::get);
        rewrite(Files.readString(file).replaceFirst("name=\"[^\"]*\"", "name=\"Other\""));
        poll(watch, 4);
        assertEquals(List.of(), changedFiles);
        dialogOpen.set(false);
        poll(watch, 2);
        assertEquals(List.of(file), changedFiles);
        dialogOpen.set(true);
        Files.delete(file);
        poll(watch, 4);
        assertEquals(List.of(), deleted);
        dialogOpen.set(false);
        poll(watch, 2);
        assertEquals(List.of(file), deleted);
    }

    @Test
    void theSameScenarioInAnotherFormatIsNotReported() throws IOException {
        FileWatch watch = watch(() -> false);
        rewrite(Files.readString(file).replace("\n", "\n\n"));
        poll(watch, 4);
        assertEquals(List.of(), changedFiles);
    }

    @Test
    void aFileThatBecomesInvalidIsReportedOnceAndReadAgainWhenItIsRepaired() throws IOException {
        FileWatch watch = watch(() -> false);
        String whole = Files.readString(file);
        rewrite("<scenario");
        poll(watch, 1);
        assertEquals(List.of(), broken, "the file may still be growing");
        poll(watch, 4);
        assertEquals(1, broken.size());
        assertEquals(1, broken.get(0).problems().get(0).location().line());
        assertEquals(List.of(), changedFiles);
        assertTrue(callOnEdt(() -> workspace.scenario().isPresent()), "the scenario remains open");
        assertTrue(callOnEdt(workspace::isChanged), "no file holds it now");
        rewrite(whole);
        poll(watch, 4);
        assertFalse(callOnEdt(workspace::isChanged));
        assertEquals(List.of(), changedFiles, "it is what is open");
        rewrite(whole.replaceFirst("seed=\"\\d+\"", "").replaceFirst("<scenario ", "<scenario seed=\"4711\" "));
        poll(watch, 4);
        assertEquals(List.of(file), changedFiles);
        assertEquals(1, broken.size());
    }

    @Test
    void aDeletedFileMakesTheScenarioUnsavedUntilItIsBack() throws IOException {
        FileWatch watch = watch(() -> false);
        String whole = Files.readString(file);
        poll(watch, 2);
        Files.delete(file);
        poll(watch, 1);
        assertEquals(List.of(), deleted, "the file may be about to be replaced");
        poll(watch, 4);
        assertEquals(List.of(file), deleted);
        assertTrue(callOnEdt(workspace::isChanged), "no file holds it now");
        rewrite(whole);
        poll(watch, 4);
        assertFalse(callOnEdt(workspace::isChanged));
        assertEquals(List.of(), changedFiles, "it is what is open");
        Files.delete(file);
        poll(watch, 4);
        assertEquals(List.of(file, file), deleted);
    }

    @Test
    void whatAPollHasReadBeforeASaveIsNotReported() throws IOException {
        FileWatch watch = watch(() -> false);
        poll(watch, 1);
        edit();
        runOnEdt(() -> {
            watch.poll();
            while (BackgroundThreads.count() > 0) {
                Thread.onSpinWait();
            }
            // The result of the poll is in the event queue, and that of a save comes before it.
            OpenDocument open = workspace.openDocument().orElseThrow();
            documentStore.markSaved(open.document(), file, open.document().edited());
        });
        Await.until("the end of the poll", () -> !watch.isPolling());
        assertEquals(List.of(), changedFiles);
        assertFalse(callOnEdt(workspace::isChanged));
    }

    /** Returns a watch that is polled only by the test, not by its timer, however long the test takes. */
    private FileWatch watch(BooleanSupplier busy) {
        return callOnEdt(() -> {
            FileWatch watch = new FileWatch(workspace, busy, changedFiles::add, broken::add, deleted::add);
            watch.close();
            return watch;
        });
    }

    private void rewrite(String text) throws IOException {
        Files.writeString(file, text);
        Files.setLastModifiedTime(
                file, FileTime.fromMillis(Files.getLastModifiedTime(file).toMillis() + 5000));
    }

    private static void poll(FileWatch watch, int times) {
        for (int i = 0; i < times; i++) {
            runOnEdt(watch::poll);
            Await.until("the end of a poll", () -> !watch.isPolling());
        }
    }

    private Autosave autosave(RecoveryStore recovery) {
        Autosave autosave = callOnEdt(() -> new Autosave(workspace, recovery, failures::add));
        runOnEdt(autosave::saveUnsavedEdits);
        return autosave;
    }

    private void send(Command command) {
        run.send(List.of(command), results -> {});
    }

    private void edit() {
        runOnEdt(() -> send(new Command.MoveObstacle("pole", ELSEWHERE)));
        Await.until("the edit", () -> {
            SessionFrames.poll(workspace);
            return workspace.isChanged();
        });
    }
}
