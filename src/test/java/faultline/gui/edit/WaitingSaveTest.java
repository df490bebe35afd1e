package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.Await;
import faultline.gui.BackgroundThreads;
import faultline.gui.EdtChecker;
import faultline.gui.document.DocumentStore;
import faultline.scenario.Scenario;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that edits and undo during a restart or a move of the run are unsaved changes, which a save contains. */
@ExtendWith(EdtChecker.class)
class WaitingSaveTest {

    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.5));

    @TempDir
    private Path folder;

    private final EditedRun run = new EditedRun();
    private final DocumentStore store = callOnEdt(() -> new DocumentStore(run.workspace()));
    private final CountDownLatch release = new CountDownLatch(1);
    private List<TimedCommand> before;
    private Path file;
    private boolean saved;

    /** What makes edits wait. */
    private enum Task {
        RESTART,
        MOVE
    }

    @BeforeEach
    void advance() {
        file = folder.resolve("office.xml");
        run.advance(100);
        before = run.timeline();
    }

    @AfterEach
    void close() {
        release.countDown();
        run.close();
    }

    /** Starts a task, which does not end before it is released, and does more during the task. */
    private void during(Task task, Runnable actions) {
        runOnEdt(() -> {
            run.workspace().setControllerChoice((setup, name) -> {
                awaitRelease();
                return setup;
            });
            if (task == Task.RESTART) {
                run.controller().restart();
            } else {
                run.controller().navigator().seek(50);
            }
            actions.run();
        });
    }

    private void awaitRelease() {
        try {
            release.await();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    /** Saves, on the event dispatch thread. */
    private void save() {
        store.save(file, () -> saved = true);
    }

    private List<TimedCommand> savedTimeline() {
        Await.until("the save", () -> saved);
        try {
            return Scenario.load(file).setup().timeline();
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    private void assertIsChanged() {
        assertTrue(callOnEdt(run.workspace()::isChanged));
        assertTrue(callOnEdt(run.workspace()::awaitsCommands), "the close question asks");
    }

    private void assertIsSaved() {
        run.rest();
        assertEquals(run.timeline(), savedTimeline());
        assertFalse(callOnEdt(run.workspace()::isChanged));
    }

    @ParameterizedTest
    @EnumSource(Task.class)
    void aSaveHasTheUndoThatWaits(Task task) {
        run.send(FAULT);
        during(task, () -> {
            run.edits().undo();
            save();
        });
        assertIsChanged();
        release.countDown();
        assertEquals(before, savedTimeline());
        assertIsSaved();
    }

    @ParameterizedTest
    @EnumSource(Task.class)
    void aSaveHasTheCommandThatWaits(Task task) {
        during(task, () -> {
            run.sender().send(FAULT);
            save();
        });
        assertIsChanged();
        release.countDown();
        assertEquals(FAULT, savedTimeline().get(before.size()).command());
        assertIsSaved();
    }

    /** The undo waits for the answer first, and then for the restart. */
    @Test
    void aSaveHasAnUndoThatWaitsForTheAnswerToo() {
        runOnEdt(() -> {
            run.sender().send(FAULT);
            run.edits().undo();
        });
        during(Task.RESTART, this::save);
        release.countDown();
        assertEquals(before, savedTimeline());
        assertIsSaved();
    }

    @ParameterizedTest
    @EnumSource(Task.class)
    void anEditIsAChangeWithoutASave(Task task) {
        during(task, () -> run.sender().send(FAULT));
        assertIsChanged();
        release.countDown();
        run.rest();
        assertTrue(callOnEdt(run.workspace()::isChanged));
    }

    @Test
    void aRefusedCommandIsNoChangeInTheEnd() {
        during(Task.MOVE, () -> run.sender().send(new Command.ClearFault("left", new Fault.Stuck(0.5))));
        assertIsChanged();
        release.countDown();
        run.rest();
        assertFalse(callOnEdt(run.workspace()::isChanged));
    }

    /** A step is not an edit. */
    @Test
    void aStepIsNoChange() {
        during(Task.MOVE, run.controller()::step);
        assertFalse(callOnEdt(run.workspace()::isChanged));
    }

    @Test
    void aSaveHasTheCommandAfterACancelledMove() {
        during(Task.MOVE, () -> {
            run.sender().send(FAULT);
            save();
            run.workspace().cancelTask();
        });
        assertEquals(FAULT, savedTimeline().get(before.size()).command());
        assertIsSaved();
    }

    @Test
    void aSaveHasTheCommandIfAnotherScenarioIsOpened() {
        run.send(FAULT);
        during(Task.RESTART, () -> {
            run.edits().undo();
            run.sender().send(FAULT);
            save();
            store.openShipped("yard.xml");
        });
        release.countDown();
        assertEquals(before.size() + 2, savedTimeline().size(), "the command has dropped the undo");
        Await.until("the other scenario", () -> run.workspace().file().isEmpty());
        assertFalse(callOnEdt(run.workspace()::isChanged));
    }

    @Test
    void aSaveHasTheUndoIfTheWorkspaceIsClosed() {
        run.send(FAULT);
        during(Task.MOVE, () -> {
            run.edits().undo();
            save();
            run.workspace().close();
        });
        assertEquals(before, savedTimeline());
        release.countDown();
        BackgroundThreads.awaitEnd();
    }
}
