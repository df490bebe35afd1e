package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Tests that an undo that is requested together with an edit, a restart or a move of the run undoes that edit. */
@ExtendWith(EdtChecker.class)
class WaitingUndoTest {

    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.5));

    private final EditedRun run = new EditedRun();
    private List<TimedCommand> before;

    @BeforeEach
    void advance() {
        run.advance(100);
        before = run.timeline();
    }

    @AfterEach
    void close() {
        run.close();
    }

    @Test
    void anEditOfARestartedRun() {
        assertIsUndone(() -> {
            run.sender().send(FAULT);
            run.edits().undo();
            run.controller().restart();
        });
    }

    @Test
    void anEditOfAMovedRun() {
        assertIsUndone(() -> {
            run.sender().send(FAULT);
            run.edits().undo();
            run.controller().navigator().seek(50);
        });
    }

    @Test
    void anEarlierEditDuringARestart() {
        run.send(FAULT);
        assertIsUndone(() -> {
            run.controller().restart();
            run.edits().undo();
        });
    }

    @Test
    void anEarlierEditDuringAMove() {
        run.send(FAULT);
        assertIsUndone(() -> {
            run.controller().navigator().seek(50);
            run.edits().undo();
        });
    }

    @Test
    void anEarlierEditDuringAMoveThatIsCancelled() {
        run.send(FAULT);
        runOnEdt(() -> {
            run.controller().navigator().seek(50);
            run.edits().undo();
            run.workspace().cancelTask();
        });
        run.rest();
        assertEquals(Optional.of("Fault in left"), callOnEdt(run.edits()::redoName));
        assertTrue(SessionFrames.frame(run.workspace()).snapshot().sensors().stream()
                .allMatch(sensor -> sensor.faults().isEmpty()));
    }

    @Test
    void aSensorIsDeletedAfterTheRunHasAnsweredAnUndo() {
        run.send(FAULT);
        runOnEdt(() -> {
            run.edits().undo();
            run.sensors().remove("left", restored -> {});
            assertTrue(run.edits().canUndo());
            assertEquals(Optional.empty(), run.edits().undoName(), "it is not known yet");
        });
        run.rest();
        assertEquals(Optional.of("Delete left"), callOnEdt(run.edits()::undoName));
        run.undo();
        assertEquals(before, run.timeline());
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        assertFalse(callOnEdt(run.workspace()::isChanged));
    }

    @Test
    void aDeletionThatWaitsIsUndoneByALaterUndo() {
        run.send(FAULT);
        runOnEdt(() -> {
            run.edits().undo();
            run.sensors().remove("left", restored -> {});
            run.edits().undo();
        });
        run.rest();
        assertEquals(Optional.of("Delete left"), callOnEdt(run.edits()::redoName));
        assertEquals(before, run.timeline());
    }

    @Test
    void aSensorIsDeletedAlthoughItIsRenamedBefore() {
        List<String> ids = run.scenario().setup().robot().sensorIds();
        List<String> restored = new ArrayList<>();
        run.send(FAULT);
        runOnEdt(() -> {
            run.edits().undo();
            run.sensors().remove("left", restored::add);
            run.sensors().rename("left", "port");
        });
        run.rest();
        assertEquals(ids.size() - 1, run.scenario().setup().robot().sensorIds().size());
        assertEquals(Optional.of("Delete port"), callOnEdt(run.edits()::undoName));
        run.undo();
        assertEquals(List.of("port"), restored);
        run.undo();
        assertEquals(ids, run.scenario().setup().robot().sensorIds());
        assertEquals(before, run.timeline());
    }

    /** Asserts that the timeline is what it was before the fault, which can be redone once. */
    private void assertIsUndone(Runnable actions) {
        runOnEdt(actions);
        run.rest();
        assertEquals(before, run.timeline());
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        run.redo();
        assertEquals(before.size() + 1, run.timeline().size());
        assertEquals(Optional.empty(), callOnEdt(run.edits()::redoName));
        run.undo();
        assertEquals(before, run.timeline());
        assertFalse(callOnEdt(run.workspace()::isChanged));
    }
}
