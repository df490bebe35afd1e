package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.BackgroundThreads;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.WorkspaceListener;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Changes that restart the run, together with others before the restart is complete. */
@ExtendWith(EdtChecker.class)
class MovedStartTest {

    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.5));

    private final EditedRun run = new EditedRun();
    private final ScenarioEditor editor = callOnEdt(() -> new ScenarioEditor(run.controller(), run.edits()));
    private Pose start;
    private Pose moved;

    @BeforeEach
    void advance() {
        run.advance(100);
        start = start();
        moved = new Pose(start.x() + 0.05, start.y(), start.heading());
    }

    @AfterEach
    void close() {
        run.close();
    }

    private Pose start() {
        return run.scenario().setup().start();
    }

    /** Moves the start, on the event dispatch thread. */
    private void moveStart() {
        editor.moveStart(run.workspace().scenario().orElseThrow().setup(), moved);
    }

    private void assertMoved() {
        run.rest();
        assertEquals(moved, start());
        assertEquals(Optional.of("Move start position"), callOnEdt(run.edits()::undoName));
    }

    @Test
    void theStartAndTheEditBeforeAreUndoneInQuickSuccession() {
        run.send(FAULT);
        runOnEdt(this::moveStart);
        assertMoved();
        runOnEdt(() -> {
            run.edits().undo();
            run.edits().undo();
        });
        run.rest();
        assertEquals(List.of(), run.timeline());
        assertEquals(start, start());
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
    }

    /** The second move is made before the first one is in the scenario. */
    @Test
    void twoQuickMovesAreUndoneOneByOne() {
        Pose further = new Pose(start.x() + 0.1, start.y(), start.heading());
        runOnEdt(() -> {
            moveStart();
            editor.moveStart(run.workspace().scenario().orElseThrow().setup(), further);
        });
        run.rest();
        assertEquals(further, start());
        run.undo();
        assertMoved();
        run.undo();
        assertEquals(start, start());
        run.redo();
        run.redo();
        assertEquals(further, start());
        runOnEdt(() -> {
            run.edits().undo();
            run.edits().undo();
        });
        run.rest();
        assertEquals(start, start());
    }

    @Test
    void anotherChangeAtOnceKeepsBoth() {
        runOnEdt(() -> {
            moveStart();
            editor.edit(
                    "edit.properties",
                    now -> now.withSetup(now.setup().withSeed(7)),
                    now -> now.withSetup(now.setup().withSeed(1)));
        });
        run.rest();
        assertEquals(moved, start());
        assertEquals(7, run.scenario().setup().seed());
        run.undo();
        assertMoved();
        run.undo();
        assertEquals(start, start());
    }

    @Test
    void aMoveOfTheRunAtOnceKeepsTheStart() {
        runOnEdt(() -> {
            moveStart();
            run.controller().navigator().seek(50);
        });
        assertMoved();
        SessionFrames.awaitTick(run.workspace(), 50);
    }

    /** The start is moved as soon as the run has answered the commands before, which may take a second. */
    @Test
    void aMovedStartIsAChangeAtOnce() {
        runOnEdt(() -> {
            moveStart();
            assertTrue(run.workspace().isChanged());
        });
        assertMoved();
        runOnEdt(() -> {
            run.edits().undo();
            assertTrue(run.workspace().isChanged());
        });
        run.rest();
        assertFalse(callOnEdt(run.workspace()::isChanged));
    }

    @Test
    void theStartIsKeptIfTheRestartIsCancelled() {
        run.send(FAULT);
        AtomicInteger deferred = new AtomicInteger();
        runOnEdt(() -> {
            run.workspace().addListener(new WorkspaceListener() {
                @Override
                public void setupChangeDeferred() {
                    deferred.incrementAndGet();
                }
            });
            moveStart();
            run.workspace().cancelTask();
        });
        // The change is made when the commands before it have been answered, and then reported.
        Await.until("the report", () -> deferred.get() == 1);
        assertMoved();
        assertTrue(run.tick() >= 100, "the run is the one before");
        run.restart();
        assertEquals(0, run.tick());
        assertMoved();
        run.undo();
        assertEquals(start, start());
        run.undo();
        assertEquals(List.of(), run.timeline());
    }

    @Test
    void anEditThatIsNotAnsweredYetIsKept() {
        runOnEdt(() -> {
            run.sender().send(FAULT);
            moveStart();
        });
        run.rest();
        assertEquals(moved, start());
        assertEquals(1, run.timeline().size());
        run.undo();
        run.undo();
        assertEquals(start, start());
        assertEquals(List.of(), run.timeline());
    }

    @Test
    void anUndoAndAnEditThatAreNotAnsweredYetAreKept() {
        run.send(FAULT);
        run.advance(5);
        runOnEdt(() -> {
            run.edits().undo();
            run.sender().send(FAULT);
            moveStart();
        });
        run.rest();
        assertEquals(moved, start());
        while (callOnEdt(run.edits()::canUndo)) {
            run.undo();
        }
        assertEquals(List.of(), run.timeline());
        assertEquals(start, start());
    }

    /** The run after the other task has the change. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aRestartThatIsReplacedIsNotReportedAsDeferred(boolean byMove) {
        AtomicInteger deferred = new AtomicInteger();
        CountDownLatch ended = new CountDownLatch(1);
        runOnEdt(() -> {
            run.workspace().addListener(new WorkspaceListener() {
                @Override
                public void setupChangeDeferred() {
                    deferred.incrementAndGet();
                }
            });
            run.workspace().setControllerChoice((setup, name) -> {
                awaitUninterruptibly(ended);
                return setup;
            });
            moveStart();
        });
        runOnEdt(() -> {
            run.workspace().setControllerChoice((setup, name) -> setup);
            if (byMove) {
                run.controller().navigator().seek(50);
            } else {
                run.controller().restart();
            }
        });
        assertMoved();
        ended.countDown();
        BackgroundThreads.awaitEnd();
        assertEquals(0, callOnEdt(deferred::get));
    }

    private static void awaitUninterruptibly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void eventsKeepTheirTimesInTicksOfAnotherLength() {
        run.send(FAULT);
        double before = run.timeline().get(0).time();
        double dt = run.scenario().setup().dt();
        runOnEdt(() -> {
            editor.edit(
                    "edit.controller",
                    now -> now.withSetup(now.setup().withTick(2 * dt)),
                    now -> now.withSetup(now.setup().withTick(dt)));
            editor.edit(
                    "edit.properties",
                    now -> now.withSetup(now.setup().withSeed(7)),
                    now -> now.withSetup(now.setup().withSeed(1)));
        });
        run.rest();
        assertEquals(2 * dt, run.scenario().setup().dt());
        assertEquals(before, run.timeline().get(0).time());
        run.undo();
        run.undo();
        run.undo();
        assertEquals(List.of(), run.timeline());
        assertEquals(dt, run.scenario().setup().dt());
    }

    /** The run continues with its own ticks. */
    @Test
    void eventsKeepTheirTimesIfTheChangeOfTheTickIsCancelled() {
        runOnEdt(() -> {
            run.controller().change(now -> now.withSetup(now.setup().withTick(0.02)));
            run.workspace().cancelTask();
        });
        Await.until(
                "the change",
                () -> run.workspace().scenario().orElseThrow().setup().dt() == 0.02);
        run.advance(9);
        run.send(FAULT);
        assertEquals(1.1, run.timeline().get(0).time(), 1e-9);
        run.restart();
        run.undo();
        assertEquals(List.of(), run.timeline());
    }
}
