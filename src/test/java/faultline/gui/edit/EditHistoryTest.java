package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Journal;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class EditHistoryTest {

    private final EditHistory history = new EditHistory();
    private final List<Integer> applied = new ArrayList<>();
    private int nextGesture;

    private SetupEdit edit(int gesture) {
        return new SetupEdit(() -> "edit " + gesture, gesture, () -> applied.add(-gesture), () -> applied.add(gesture));
    }

    private int countUndoable() {
        int count = 0;
        while (history.nextUndo().isPresent()) {
            history.mark(history.nextUndo().get(), false);
            count++;
        }
        return count;
    }

    @Test
    void theLastThousandEditsAreKept() {
        for (int gesture = 0; gesture < 1001; gesture++) {
            history.add(edit(gesture));
        }
        assertEquals("edit 1000", history.nextUndo().orElseThrow().name());
        assertEquals(1000, countUndoable());
        assertEquals("edit 1", history.nextRedo().orElseThrow().name());
    }

    @Test
    void editsOfOneGestureAreOne() {
        assertTrue(history.add(edit(1)));
        assertFalse(history.add(edit(1)));
        assertTrue(history.add(edit(2)));
        assertEquals(2, countUndoable());
    }

    @Test
    void aNewEditDropsThoseThatAreUndone() {
        history.add(edit(1));
        history.add(edit(2));
        history.mark(history.nextUndo().orElseThrow(), false);
        history.add(edit(3));
        assertTrue(history.nextRedo().isEmpty());
        assertEquals(2, countUndoable());
    }

    /** Does a command at a tick, given the id of the sensor that it switches off. */
    private CommandEdit execute(long tick, String sensor) {
        Command command = new Command.SwitchSensor(sensor, false);
        CommandEdit edit = new CommandEdit(
                nextGesture++,
                List.of(new CommandResult.Executed(tick, command, List.of(new Command.SwitchSensor(sensor, true)))));
        history.add(edit);
        history.addChange(tick, edit, true);
        return edit;
    }

    @Test
    void severalCommandsAreUndoneInReverse() {
        Command off = new Command.SwitchSensor("left", false);
        Command on = new Command.SwitchSensor("left", true);
        Command platform = new Command.SetPlatform(0.3, 0.2, 0.3);
        CommandEdit edit = new CommandEdit(
                1,
                List.of(
                        new CommandResult.Executed(1, off, List.of(on)),
                        new CommandResult.Executed(1, platform, List.of(platform))));
        assertEquals(List.of(off, platform), edit.redoCommands());
        assertEquals(List.of(platform, on), edit.undoCommands());
        assertFalse(edit.isNoOp());
    }

    private void assertDoneAndUndone(Edit done, Edit undone) {
        assertEquals(Optional.ofNullable(done), history.nextUndo());
        assertEquals(Optional.ofNullable(undone), history.nextRedo());
    }

    @Test
    void editsAreUndoneAndRedoneAsTheRunPassesTheirTicks() {
        CommandEdit first = execute(10, "front");
        CommandEdit second = execute(20, "left");
        assertFalse(history.moveTo(20));
        assertDoneAndUndone(second, null);
        assertTrue(history.moveTo(19));
        assertDoneAndUndone(first, second);
        assertEquals(List.of(second), history.editsAhead());
        assertFalse(history.moveTo(10));
        assertTrue(history.moveTo(9));
        assertDoneAndUndone(null, first);
        assertEquals(List.of(first, second), history.editsAhead());
        assertFalse(history.advanceTo(9));
        assertTrue(history.advanceTo(10));
        assertDoneAndUndone(first, second);
        assertTrue(history.moveTo(30));
        assertDoneAndUndone(second, null);
        assertEquals(List.of(), history.editsAhead());
        assertEquals(10, history.firstTick(first));
        assertEquals(20, history.firstTick(second));
    }

    @Test
    void anEditThatWasUndoneDuringTheRunIsDoneAtEarlierTicks() {
        CommandEdit only = execute(10, "front");
        history.mark(only, false);
        history.addChange(20, only, false);
        assertDoneAndUndone(null, only);
        assertEquals(List.of(), history.editsAhead());
        assertTrue(history.moveTo(19));
        assertDoneAndUndone(only, null);
        assertTrue(history.moveTo(20));
        assertDoneAndUndone(null, only);
        assertEquals(List.of(), history.editsAhead());
        assertEquals(10, history.firstTick(only));
    }

    @Test
    void anEarlierCommandLeavesLaterEditsToTheUser() {
        CommandEdit first = execute(10, "front");
        CommandEdit second = execute(20, "left");
        history.moveTo(12);
        assertTrue(history.fork(13));
        CommandEdit between = execute(13, "rear");
        assertDoneAndUndone(between, second);
        assertTrue(history.moveTo(12));
        assertDoneAndUndone(first, between);
        history.moveTo(100);
        assertDoneAndUndone(between, second);
        assertFalse(history.fork(101));
    }

    @Test
    void aCommandAtTheTickOfALaterEditIsBeforeIt() {
        CommandEdit first = execute(10, "front");
        history.moveTo(9);
        assertTrue(history.fork(10));
        assertDoneAndUndone(null, first);
    }

    @Test
    void aCommandWithoutEffectAlsoLeavesLaterEditsToTheUser() {
        CommandEdit first = execute(10, "front");
        CommandEdit second = execute(20, "left");
        history.moveTo(12);
        assertTrue(history.fork(13));
        assertFalse(history.advanceTo(100));
        assertDoneAndUndone(first, second);
    }

    @Test
    void editsThatTheRunPassesBeforeACommandAreDone() {
        execute(10, "front");
        CommandEdit second = execute(20, "left");
        history.moveTo(12);
        assertFalse(history.fork(21));
        assertDoneAndUndone(second, null);
    }

    @Test
    void aRestartIncludesAllEditsFromTheStart() {
        execute(10, "front");
        CommandEdit second = execute(20, "left");
        history.moveTo(5);
        List<List<Long>> ticks = new ArrayList<>();
        history.restart((edit, executed) -> {
            ticks.add(executed.stream().map(Journal.Entry::tick).toList());
            return edit(ticks.size());
        });
        assertEquals(List.of(List.of(10L), List.of(20L)), ticks);
        assertEquals("edit 2", history.nextUndo().orElseThrow().name());
        assertTrue(history.nextRedo().isEmpty());
        assertFalse(history.moveTo(0));
        assertEquals("edit 2", history.nextUndo().orElseThrow().name());
        assertEquals(0, history.firstTick(second));
        history.clear();
        assertDoneAndUndone(null, null);
    }
}
