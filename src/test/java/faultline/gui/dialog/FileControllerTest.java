package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.action.ActionRegistry;
import faultline.gui.document.RecoveryPrompt;
import faultline.gui.document.RecoveryStore;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@ExtendWith(EdtChecker.class)
class FileControllerTest {

    private static final Set<String> LOSING_ANSWERS = Set.of("revert.revert", "changed.reload", "unsaved.discard");

    @TempDir
    private Path folder;

    /** The keys of the answers that are given. */
    private Set<String> answers = LOSING_ANSWERS;

    /** What was asked, in order. */
    private final List<String> questions = new CopyOnWriteArrayList<>();

    /** The text of the last question. */
    private volatile String question;

    /** The file that was last suggested for a save. */
    private volatile Path suggested;

    private final Workspace workspace = callOnEdt(Workspace::new);
    private final RunController run = callOnEdt(() -> new RunController(workspace));
    private final ActionRegistry actions = new ActionRegistry();
    private final FileController files =
            callOnEdt(() -> new FileController(new JPanel(), workspace, () -> false, new AnsweringDialogs()));

    @BeforeEach
    void addActions() {
        runOnEdt(() -> {
            files.addTo(actions, () -> {});
            files.setLeaveQuestion((leaving, leave) -> questions.add("recording"));
        });
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    private Path openCopy() throws IOException {
        Path file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        runOnEdt(() -> files.openWithoutAsking(file));
        Await.until("open", () -> workspace.file().isPresent());
        return file;
    }

    private void edit() {
        runOnEdt(() -> run.send(List.of(new Command.SwitchSensor("left", false)), results -> {}));
        Await.until("the edit", workspace::isChanged);
    }

    private void perform(String action) {
        runOnEdt(() -> actions.get(action).actionPerformed(null));
    }

    @Test
    void openAsksAboutARecordingBeforeAFileIsChosen() {
        perform("open");
        assertEquals(List.of("recording"), questions);
    }

    @Test
    void revertAsksAboutARecording() throws IOException {
        Path file = openCopy();
        edit();
        perform("revert");
        assertEquals(List.of("revert", "recording"), questions);
        assertEquals(Optional.of(file), callOnEdt(workspace::file));
        assertTrue(callOnEdt(workspace::isChanged));
    }

    @Test
    void reloadAfterAChangeOnDiskAsksAboutARecording() throws IOException {
        Path file = openCopy();
        runOnEdt(() -> files.onFileChangedOnDisk(file));
        assertEquals(List.of("changed", "recording"), questions);
    }

    @Test
    void reloadInsteadOfASaveAsksAboutARecording() throws IOException {
        Path file = openCopy();
        edit();
        Files.writeString(file, Files.readString(file).replaceFirst("duration=\"180\"", "duration=\"170\""));
        perform("save");
        Await.until("the question", () -> questions.size() == 2);
        assertEquals(List.of("changed", "recording"), questions);
    }

    /** The command is executed when the move ends. */
    @Test
    void aCommandDuringAMoveOfTheRunIsAskedAbout() throws IOException {
        openCopy();
        CountDownLatch end = new CountDownLatch(1);
        AtomicBoolean left = new AtomicBoolean();
        runOnEdt(() -> {
            files.setLeaveQuestion((leaving, leave) -> leave.run());
            workspace.setControllerChoice((setup, name) -> {
                await(end);
                return setup;
            });
            run.navigator().seek(0);
            files.runIfChangesHandled(() -> left.set(questions.isEmpty()));
            run.send(List.of(new Command.SwitchSensor("left", false)), results -> {});
            files.runIfChangesHandled(() -> {});
        });
        assertTrue(left.get(), "the move alone is no change");
        assertEquals(List.of("unsaved"), questions);
        end.countDown();
        Await.until("the edit", () -> workspace.task().isEmpty() && !workspace.awaitsCommands());
        assertTrue(callOnEdt(workspace::isChanged));
    }

    /** The window can be used while the file is written. */
    @Test
    void anEditDuringTheSaveBeforeTheScenarioIsLeftIsAskedAboutAndSaved() throws Exception {
        Path file = openCopy();
        edit();
        AtomicReference<Boolean> changed = new AtomicReference<>();
        runOnEdt(() -> {
            files.setLeaveQuestion((leaving, leave) -> leave.run());
            answers = Set.of("unsaved.save");
            workspace.addListener(new WorkspaceListener() {
                @Override
                public void scenarioSaved(Path saved) {
                    if (questions.size() == 1) {
                        run.send(List.of(new Command.SwitchSensor("front", false)), results -> {});
                    }
                }
            });
            files.runIfChangesHandled(() -> changed.set(workspace.isChanged()));
        });
        Await.until("the end", () -> changed.get() != null);
        assertEquals(List.of("unsaved", "unsaved"), questions);
        assertFalse(changed.get());
        assertEquals(
                List.of("left", "front"),
                Scenario.load(file).setup().timeline().stream()
                        .map(event -> ((Command.SwitchSensor) event.command()).sensorId())
                        .toList());
    }

    /** Another recording may have been begun while the file was written. */
    @Test
    void theQuestionAboutARecordingIsAskedAgainAfterTheSaveBeforeTheScenarioIsLeft() throws IOException {
        openCopy();
        edit();
        AtomicBoolean left = new AtomicBoolean();
        runOnEdt(() -> {
            files.setLeaveQuestion((leaving, leave) -> {
                questions.add("recording");
                leave.run();
            });
            answers = Set.of("unsaved.save");
            files.runIfChangesHandled(() -> left.set(true));
        });
        Await.until("the end", left::get);
        assertEquals(List.of("recording", "unsaved", "recording"), questions);
    }

    /** The scenario stays open, and is still recorded. */
    @Test
    void theQuestionAboutARecordingCanBeCancelled() {
        for (String answer : List.of("recording.save", "recording.discard", "unsaved.cancel")) {
            answers = Set.of(answer);
            Optional<Boolean> expected = answer.equals("unsaved.cancel")
                    ? Optional.empty()
                    : Optional.of(answer.equals("recording.discard"));
            assertEquals(expected, callOnEdt(files::askToDiscardRecording), answer);
        }
    }

    @ParameterizedTest
    @CsvSource({"office.xml, office.xml is open", "broken.xml, broken.xml was not opened"})
    void theFilesThatAreDroppedWithAnotherAreCounted(String first, String note) throws IOException {
        openCopy();
        Files.writeString(folder.resolve("broken.xml"), "<scenario");
        List<String> notes = new CopyOnWriteArrayList<>();
        runOnEdt(() -> {
            files.setLeaveQuestion((leaving, leave) -> leave.run());
            files.openFirst(List.of(folder.resolve(first), Path.of("a.xml"), Path.of("b.xml")), notes::add);
        });
        Await.until("the note", () -> !notes.isEmpty());
        assertEquals(List.of(note + ". Files that were dropped with it and not opened: 2"), notes);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The command line may name the file by a path that is relative to the working directory. */
    @Test
    void filesAreSavedBesideTheOpenOne() {
        Path office = Path.of("scenarios/office.xml");
        runOnEdt(() -> files.openWithoutAsking(office));
        Await.until("open", () -> workspace.file().isPresent());
        assertEquals(office.toAbsolutePath(), callOnEdt(files::suggestedScenarioFile));
        assertEquals(Path.of("scenarios/office.csv").toAbsolutePath(), callOnEdt(() -> files.suggestedFile(".csv")));
    }

    @Test
    void aScenarioWithoutAFileIsSavedInTheFolderOfTheLastDialog() {
        assertEquals(Path.of("scenario.xml"), callOnEdt(files::suggestedScenarioFile));
    }

    /** The package makes the desktop open files with one of the extensions, and its launcher names it. */
    @Test
    void anInstalledProgramSavesNewScenariosSoThatTheDesktopOpensThem() throws IOException {
        Path packaging = Path.of("src/conf/dist/linux");
        Matcher option = Pattern.compile("-D(faultline\\.extension)=(\\w+) ")
                .matcher(Files.readString(packaging.resolve("postinst")));
        assertTrue(option.find());
        String extension = option.group(2);
        assertTrue(Files.readString(packaging.resolve("share/faultline-mime.xml"))
                .contains("<glob pattern=\"*." + extension + "\"/>"));
        System.setProperty(option.group(1), extension);
        try {
            assertEquals(Path.of("scenario." + extension), callOnEdt(files::suggestedScenarioFile));
            perform("saveJournal");
            assertEquals(Path.of("scenario-journal." + extension), suggested);
            Path office = openCopy();
            assertEquals(office, callOnEdt(files::suggestedScenarioFile));
        } finally {
            System.clearProperty(option.group(1));
        }
    }

    @Test
    void aNewJournalIsSavedAsXml() {
        perform("saveJournal");
        assertEquals(Path.of("scenario-journal.xml"), suggested);
    }

    /** The file of the command line may still be read when the question is shown. */
    @Test
    void theRecoveryQuestionNamesTheFileThatIsBeingOpened() throws IOException, ScenarioException {
        answers = Set.of("recover.later");
        Scenario yard = Scenario.loadShipped("yard.xml");
        CountDownLatch read = new CountDownLatch(1);
        runOnEdt(() -> files.openWithoutAsking(folder.resolve("room.xml"), () -> {
            await(read);
            return yard;
        }));
        assertTrue(recoveryQuestion(yard).endsWith(" instead of room.xml."), recoveryQuestion(yard));
        read.countDown();
        Await.until("open", () -> workspace.file().isPresent());
        assertTrue(recoveryQuestion(yard).endsWith(" instead of room.xml."), recoveryQuestion(yard));
        runOnEdt(() -> files.openShippedWithoutAsking("office.xml"));
        assertFalse(recoveryQuestion(yard).contains("office.xml"), recoveryQuestion(yard));
    }

    /** Returns the question about edits of a scenario without a file, which is to be decided later. */
    private String recoveryQuestion(Scenario edits) {
        runOnEdt(() -> files.offerRecovery(
                new RecoveryStore.RecoveredFile(folder.resolve("1-0.xml"), Instant.EPOCH, null, null, edits),
                answer -> assertEquals(RecoveryPrompt.Answer.LATER, answer)));
        return question;
    }

    /** Chooses the office, and one of the answers. */
    private final class AnsweringDialogs extends FileDialogs {

        AnsweringDialogs() {
            super(new JPanel());
        }

        @Override
        Optional<Path> chooseFileToOpen(String action, Path selected) {
            questions.add(action);
            return Optional.of(Path.of("scenarios/office.xml"));
        }

        @Override
        Optional<Path> chooseFileToSave(String action, Path suggestion) {
            suggested = suggestion;
            return Optional.empty();
        }

        @Override
        int showOptions(String key, String text, String... answerKeys) {
            questions.add(key);
            question = text;
            return IntStream.range(0, answerKeys.length)
                    .filter(i -> answers.contains(answerKeys[i]))
                    .findFirst()
                    .orElseThrow();
        }
    }
}
