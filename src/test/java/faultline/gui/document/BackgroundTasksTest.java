package faultline.gui.document;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import java.awt.EventQueue;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class BackgroundTasksTest {

    private final List<String> outcomes = new ArrayList<>();
    private final CompletableFuture<Thread> worker = new CompletableFuture<>();
    private final CompletableFuture<Void> released = new CompletableFuture<>();

    static Stream<Arguments> works() {
        return Stream.of(
                work("written", () -> "written"),
                work("full", () -> {
                    throw new IOException("full");
                }),
                work("cancelled", () -> {
                    throw new CancellationException("cancelled");
                }),
                work("broken", () -> {
                    throw new AssertionError("broken");
                }));
    }

    private static Arguments work(String outcome, Callable<String> work) {
        return Arguments.of(outcome, work);
    }

    private String perform(Callable<String> work) throws Exception {
        worker.complete(Thread.currentThread());
        released.join();
        return work.call();
    }

    private void addOutcome(String outcome) {
        assertTrue(EventQueue.isDispatchThread());
        outcomes.add(outcome);
    }

    @ParameterizedTest
    @MethodSource("works")
    void theProgramExitsOnlyAfterTheTaskHasEndedEvenIfItFails(String outcome, Callable<String> work) throws Exception {
        runOnEdt(() -> BackgroundTasks.computeBeforeExit(
                () -> perform(work), this::addOutcome, failure -> addOutcome(failure.getMessage())));
        assertFalse(worker.get().isDaemon(), "a daemon thread would not keep the program from exiting");
        assertTrue(worker.get().isAlive());
        released.complete(null);
        worker.get().join();
        Await.until("the outcome", () -> outcomes.size() == 1);
        assertEquals(List.of(outcome), outcomes);
    }

    @Test
    void theProgramExitsOnlyAfterWorkThatIsStartedWithTheResultOfOtherWork() throws Exception {
        CompletableFuture<Void> exit = new CompletableFuture<>();
        runOnEdt(() -> {
            BackgroundTasks.computeBeforeExit(
                    () -> perform(() -> "checked"),
                    checked -> {
                        addOutcome(checked);
                        BackgroundTasks.computeBeforeExit(() -> write(exit), this::addOutcome, failure -> {});
                    },
                    failure -> {});
            BackgroundTasks.runAfterAll(() -> {
                addOutcome("exit");
                exit.complete(null);
            });
        });
        released.complete(null);
        exit.get();
        runOnEdt(() -> assertEquals(List.of("checked", "written", "exit"), outcomes));
    }

    /** Writes for some time, unless the program exits meanwhile. */
    private static String write(CompletableFuture<Void> exit) throws Exception {
        try {
            exit.get(300, TimeUnit.MILLISECONDS);
            return "cut short";
        } catch (TimeoutException ended) {
            return "written";
        }
    }

    @Test
    void theProgramAlsoWaitsForWorkThatAResultStarts() {
        runOnEdt(() -> {
            BackgroundTasks.computeBeforeExit(
                    () -> "checked",
                    checked -> BackgroundTasks.computeBeforeExit(
                            () -> perform(() -> "written"), this::addOutcome, failure -> {}),
                    failure -> {});
            BackgroundTasks.runAfterAll(() -> addOutcome("exit"));
        });
        worker.join();
        // The task that exits would be in the queue by now.
        runOnEdt(() -> assertEquals(List.of(), outcomes));
        released.complete(null);
        Await.until("the exit", () -> outcomes.size() == 2);
        assertEquals(List.of("written", "exit"), outcomes);
    }

    @Test
    void otherTasksEndWithTheProgram() throws Exception {
        runOnEdt(() -> BackgroundTasks.compute(() -> perform(() -> "read"), this::addOutcome, failure -> {}));
        assertTrue(worker.get().isDaemon());
        released.complete(null);
        Await.until("the outcome", () -> !outcomes.isEmpty());
        assertEquals(List.of("read"), outcomes);
    }
}
