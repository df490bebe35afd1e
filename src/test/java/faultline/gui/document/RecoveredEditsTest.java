package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Edits that a crash has left are kept until they are open. */
@ExtendWith(EdtChecker.class)
class RecoveredEditsTest {

    @TempDir
    private Path folder;

    private RecoveryStore own;
    private Workspace workspace;
    private DocumentStore documentStore;
    private final List<Throwable> failures = new ArrayList<>();
    private final List<RecoveryPrompt.Answer> answers = new ArrayList<>();

    @BeforeEach
    void crash() throws Exception {
        Scenario edited = Scenario.loadShipped("office.xml");
        new RecoveryStore(folder, Integer.MAX_VALUE, Instant.EPOCH).save(null, null, edited);
        own = new RecoveryStore(folder);
        workspace = callOnEdt(Workspace::new);
        documentStore = new DocumentStore(workspace);
        runOnEdt(() -> workspace.addListener(new WorkspaceListener() {
            @Override
            public void taskFailed(TaskKind task, Path file, Throwable failure) {
                failures.add(failure);
            }
        }));
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    /** Answers the offer of the edits with a request to open them. */
    private Autosave recover() {
        Autosave autosave = callOnEdt(() -> new Autosave(workspace, own, failures::add));
        runOnEdt(() -> RecoveryPrompt.offerRecovery(
                own,
                autosave,
                (found, onAnswer) -> documentStore.recover(
                        found,
                        () -> answer(onAnswer, RecoveryPrompt.Answer.RECOVER),
                        () -> answer(onAnswer, RecoveryPrompt.Answer.NOT_OPENED)),
                others -> {},
                () -> {}));
        return autosave;
    }

    private void answer(Consumer<RecoveryPrompt.Answer> onAnswer, RecoveryPrompt.Answer answer) {
        answers.add(answer);
        onAnswer.accept(answer);
    }

    private void assertOfferedAgain(Autosave autosave) throws IOException {
        RecoveryStore next = new RecoveryStore(folder);
        Await.until("the next offer", () -> next.findOrphan(Set.of()).isPresent());
        next.release();
        runOnEdt(autosave::close);
        assertEquals(List.of(RecoveryPrompt.Answer.NOT_OPENED), answers);
        assertTrue(next.findOrphan(Set.of()).isPresent(), "a window without these edits does not delete them");
    }

    @Test
    void editsWhoseRunCannotStartAreOfferedAgain() throws IOException {
        runOnEdt(() -> workspace.setControllerChoice((setup, name) -> {
            throw new IllegalStateException("no such controller");
        }));
        Autosave autosave = recover();
        Await.until("the failure", () -> failures.size() == 1);
        assertOfferedAgain(autosave);
    }

    @Test
    void editsWhoseRunStartsAtTheSecondAttemptAreThoseOfTheWindow() {
        runOnEdt(() -> workspace.setControllerChoice((setup, name) -> {
            throw new IllegalStateException("no such controller");
        }));
        Autosave autosave = recover();
        Await.until("the failure", () -> failures.size() == 1);
        runOnEdt(() -> {
            workspace.setControllerChoice((setup, name) -> setup);
            workspace.retry();
        });
        Await.until("the note of the adoption", autosave::hasEdits);
        assertEquals(List.of(RecoveryPrompt.Answer.NOT_OPENED, RecoveryPrompt.Answer.RECOVER), answers);
        assertTrue(callOnEdt(() -> workspace.scenario().isPresent()));
    }

    @Test
    void editsWhoseOpeningIsCancelledAreOfferedAgain() throws IOException {
        CountDownLatch cancelled = new CountDownLatch(1);
        runOnEdt(() -> workspace.setControllerChoice((setup, name) -> {
            try {
                cancelled.await();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
            return setup;
        }));
        Autosave autosave = recover();
        Await.until("the opening", () -> workspace.task().isPresent());
        runOnEdt(workspace::cancelTask);
        cancelled.countDown();
        assertOfferedAgain(autosave);
    }

    /** Offers the edits of this crash and of another one, and gives the answer to all of them. */
    private List<String> offerAll(BiConsumer<RecoveryStore.RecoveredFile, Consumer<RecoveryPrompt.Answer>> question)
            throws Exception {
        new RecoveryStore(folder, Integer.MAX_VALUE - 1, Instant.EPOCH)
                .save(Path.of("yard.xml"), null, Scenario.loadShipped("yard.xml"));
        List<String> events = Collections.synchronizedList(new ArrayList<>());
        Autosave autosave = callOnEdt(() -> new Autosave(workspace, own, failures::add));
        runOnEdt(() -> RecoveryPrompt.offerRecovery(
                own,
                autosave,
                (found, onAnswer) -> {
                    events.add(found.name());
                    question.accept(found, onAnswer);
                },
                others -> others.forEach(other -> events.add("left: " + other.name())),
                () -> events.add("nothing")));
        Await.until("two events", () -> events.size() == 2);
        return List.copyOf(events);
    }

    @ParameterizedTest
    @EnumSource(names = {"DISCARD", "LATER"})
    void theEditsOfSeveralCrashesAreOfferedOneAfterAnother(RecoveryPrompt.Answer answer) throws Exception {
        assertEquals(List.of("yard.xml", "Office"), offerAll((found, onAnswer) -> onAnswer.accept(answer)));
        boolean later = answer == RecoveryPrompt.Answer.LATER;
        Await.until("the end", () -> own.orphanedEdits().size() == (later ? 2 : 0));
    }

    @Test
    void theEditsThatAreLeftWhenSomeAreRecoveredAreNamed() throws Exception {
        assertEquals(
                List.of("yard.xml", "left: Office"),
                offerAll((found, onAnswer) ->
                        documentStore.recover(found, () -> onAnswer.accept(RecoveryPrompt.Answer.RECOVER), () -> {})));
    }
}
