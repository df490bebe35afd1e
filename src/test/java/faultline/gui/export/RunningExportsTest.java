package faultline.gui.export;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.action.Notes;
import faultline.gui.document.Leaving;
import faultline.gui.document.TaskProgress;
import java.awt.SecondaryLoop;
import java.awt.Toolkit;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Closes a window while files are written. An export ends on the event dispatch thread, so it is being written as long
 * as that is busy.
 */
@ExtendWith(EdtChecker.class)
class RunningExportsTest {

    private static final String QUESTION = "Faultline is still writing out.csv. Wait before closing?";
    private static final String WAITING = "The window closes after writing out.csv.";

    @TempDir
    private Path folder;

    private final List<Path> written = new ArrayList<>();
    private final List<String> errors = new ArrayList<>();
    private final List<String> questions = new ArrayList<>();
    private final List<String> kept = new ArrayList<>();
    private final RunningExports exports = callOnEdt(() -> new RunningExports(
            new JPanel(),
            written::add,
            errors::add,
            new Notes(shown -> {}, kept::add, line -> {}, removed -> kept.remove(removed))));
    private int closings;

    @Test
    void theWindowClosesAtOnceIfNothingIsBeingWritten() {
        runOnEdt(() -> {
            answer(-1);
            start("out.csv");
        });
        Await.until("the end", () -> !written.isEmpty());
        runOnEdt(() -> runIfHandled(this::close));
        assertEquals(1, closings);
        assertEquals(List.of(), questions);
    }

    @Test
    void theWindowClosesWhenTheExportIsCompleteIfTheUserWaits() {
        runOnEdt(() -> {
            answer(0);
            start("out.csv");
            runIfHandled(() -> {
                assertEquals(1, written.size());
                close();
            });
            assertEquals(List.of(QUESTION), questions);
            assertEquals(0, closings);
            assertEquals(List.of(WAITING), kept);
        });
        Await.until("the end", () -> closings > 0);
        assertEquals(List.of(), kept);
        assertTrue(Files.exists(folder.resolve("out.csv")));
    }

    @Test
    void theWindowWaitsForAllExports() {
        runOnEdt(() -> {
            answer(0);
            start("a.csv");
            start("b.csv");
            runIfHandled(() -> {
                assertEquals(2, written.size());
                close();
            });
            assertEquals(List.of("The window closes after writing a.csv, b.csv."), kept);
        });
        Await.until("the end", () -> closings > 0);
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 1, 2})
    void theWindowStaysOrClosesWhileAnExportIsBeingWritten(int answer) {
        int expected = answer == 1 ? 1 : 0;
        runOnEdt(() -> {
            answer(answer);
            start("out.csv");
            runIfHandled(this::close);
            assertEquals(expected, closings);
            assertEquals(List.of(), kept);
        });
        Await.until("the end", () -> !written.isEmpty());
        runOnEdt(() -> assertEquals(expected, closings, "closed later"));
    }

    @Test
    void onlyAnExportBegunAfterTheAnswerIsAskedAboutAgain() {
        runOnEdt(() -> {
            answer(1);
            start("out.csv");
            Leaving.begin(leaving -> exports.runIfHandled(leaving, () -> {
                close();
                if (closings == 1) {
                    leaving.ask();
                    start("next.csv");
                    leaving.ask();
                }
            }));
        });
        assertEquals(3, closings);
        assertEquals(
                List.of(QUESTION, QUESTION.replace("out.csv", "out.csv, next.csv")),
                questions,
                "a question, none, and another one");
        Await.until("both ends", () -> written.size() == 2);
    }

    @Test
    void theWindowNoLongerWaitsIfTheUserClosesItAgainAndStays() {
        runOnEdt(() -> {
            start("out.csv");
            answer(0);
            runIfHandled(this::close);
            answer(2);
            runIfHandled(this::close);
            assertEquals(List.of(), kept);
        });
        Await.until("the end", () -> !written.isEmpty());
        runOnEdt(() -> assertEquals(0, closings));
    }

    @Test
    void theWindowStaysIfTheExportFailsDuringTheQuestion() throws IOException {
        Files.createDirectory(folder.resolve("out.csv"));
        runOnEdt(() -> {
            SecondaryLoop open =
                    Toolkit.getDefaultToolkit().getSystemEventQueue().createSecondaryLoop();
            exports.setExitQuestion(question -> {
                open.enter();
                return 0;
            });
            exports.start(folder.resolve("out.csv"), RunningExportsTest::write, () -> {}, open::exit);
            runIfHandled(this::close);
        });
        assertEquals(1, errors.size(), errors::toString);
        assertEquals(0, closings);
    }

    @Test
    void theWindowStaysIfTheExportFailsThatTheUserWaitsFor() throws IOException {
        Files.createDirectory(folder.resolve("out.csv"));
        runOnEdt(() -> {
            answer(0);
            start("out.csv");
            runIfHandled(this::close);
        });
        Await.until("the failure", () -> !errors.isEmpty());
        runOnEdt(() -> {
            assertEquals(List.of(), kept);
            start("next.csv");
        });
        Await.until("the next export", () -> !written.isEmpty());
        runOnEdt(() -> assertEquals(0, closings));
    }

    @Test
    void anExportIsCancelledWithItsWindowWithoutAWord() {
        List<String> ends = new ArrayList<>();
        runOnEdt(() -> {
            exports.start(
                    folder.resolve("out.csv"),
                    (out, progress) -> {
                        while (true) {
                            progress.throwIfCancelled();
                            Thread.onSpinWait();
                        }
                    },
                    () -> ends.add("written"),
                    () -> ends.add("not written"));
            exports.cancel();
        });
        Await.until("the end", () -> !ends.isEmpty());
        runOnEdt(() -> assertEquals(List.of("not written"), ends));
        assertEquals(List.of(), errors);
        assertFalse(Files.exists(folder.resolve("out.csv")));
    }

    @Test
    void aFailureNamesTheFileAndTheReason() {
        String file = folder.resolve("picture.png").toString();
        assertEquals(
                file + " cannot be written: not enough memory",
                RunningExports.failureText(Path.of(file), new OutOfMemoryError()));
        assertEquals(
                file + " cannot be written: access is denied",
                RunningExports.failureText(Path.of(file), new AccessDeniedException(file)));
        assertEquals(
                file + " cannot be written: the name is too long",
                RunningExports.failureText(Path.of(file), new IOException(file + ": the name is too long")));
    }

    private void runIfHandled(Runnable action) {
        Leaving.begin(leaving -> exports.runIfHandled(leaving, action));
    }

    private void answer(int answer) {
        exports.setExitQuestion(question -> {
            questions.add(question);
            return answer;
        });
    }

    private void start(String name) {
        exports.start(folder.resolve(name), RunningExportsTest::write, () -> {}, () -> {});
    }

    private static void write(OutputStream out, TaskProgress progress) throws IOException {
        out.write(1);
    }

    private void close() {
        closings++;
    }
}
