package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import faultline.geometry.Pose;
import faultline.gui.change.LaterChange;
import faultline.gui.change.Rename;
import faultline.gui.change.SensorReference;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class EditHistoryTest {

    private final EditHistory history = new EditHistory();
    private final List<Integer> applied = new ArrayList<>();
    private int nextGesture;

    private SetupEdit edit(int gesture) {
        return new SetupEdit(
                () -> "edit " + gesture,
                gesture,
                SetupChange.of(() -> applied.add(-gesture), () -> applied.add(gesture)));
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

    /** Executes a command at a tick, given the id of the obstacle that it moves. */
    private CommandEdit execute(long tick, String obstacle) {
        return execute(
                tick,
                new Command.MoveObstacle(obstacle, new Pose(1, 1, 0)),
                new Command.MoveObstacle(obstacle, new Pose(2, 2, 0)));
    }

    private CommandEdit switchOff(long tick, String sensor) {
        return execute(tick, new Command.SwitchSensor(sensor, false), new Command.SwitchSensor(sensor, true));
    }

    private CommandEdit execute(long tick, Command command, Command inverse) {
        CommandEdit edit =
                new CommandEdit(nextGesture++, List.of(new CommandResult.Executed(tick, command, List.of(inverse))));
        history.add(edit);
        history.addExecution(tick, edit);
        return edit;
    }

    private void markUndone(long tick, CommandEdit edit) {
        List<CommandResult> results = results(tick, undoCommands(edit));
        history.mark(edit, false);
        history.addChange(tick, edit, false, results);
    }

    private List<Command> undoCommands(CommandEdit edit) {
        return inRun(history.undoChanges(edit));
    }

    private List<Command> redoCommands(CommandEdit edit) {
        return inRun(history.redoChanges(edit));
    }

    private static List<Command> inRun(List<LaterChange> changes) {
        return changes.stream().map(LaterChange::inRun).toList();
    }

    private static List<CommandResult> results(long tick, List<Command> commands) {
        return commands.stream()
                .map(command -> (CommandResult) new CommandResult.Executed(tick, command, List.of()))
                .toList();
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
        assertEquals(List.of(off, platform), redoCommands(edit));
        assertEquals(List.of(platform, on), undoCommands(edit));
        assertFalse(edit.isNoOp());
    }

    @Test
    void aDragDoesNotReadTheTimeline() {
        history.setPlan(tick -> fail(), UnaryOperator.identity());
        Command first = new Command.MoveObstacle("box", new Pose(1, 1, 0));
        Command second = new Command.MoveObstacle("box", new Pose(2, 2, 0));
        CommandEdit drag = execute(1, first, new Command.MoveObstacle("box", new Pose(3, 3, 0)));
        nextGesture--;
        execute(2, second, first);
        assertDoneAndUndone(drag, null);
    }

    /** Follows a run without events. */
    private boolean moveTo(long tick) {
        return history.moveTo(tick, false, (edit, executed) -> fail());
    }

    private void assertDoneAndUndone(Edit done, Edit undone) {
        assertEquals(Optional.ofNullable(done), history.nextUndo());
        assertEquals(Optional.ofNullable(undone), history.nextRedo());
    }

    @Test
    void editsAreUndoneAndRedoneAsTheRunPassesTheirTicks() {
        CommandEdit first = execute(10, "box");
        CommandEdit second = execute(20, "wall");
        assertFalse(moveTo(20));
        assertDoneAndUndone(second, null);
        assertTrue(moveTo(19));
        assertDoneAndUndone(first, second);
        assertEquals(List.of(second), history.editsAhead());
        assertFalse(moveTo(10));
        assertTrue(moveTo(9));
        assertDoneAndUndone(null, first);
        assertEquals(List.of(first, second), history.editsAhead());
        assertFalse(history.advanceTo(9));
        assertTrue(history.advanceTo(10));
        assertDoneAndUndone(first, second);
        assertTrue(moveTo(30));
        assertDoneAndUndone(second, null);
        assertEquals(List.of(), history.editsAhead());
        assertEquals(10, history.firstTick(first));
        assertEquals(20, history.firstTick(second));
    }

    @Test
    void anEditThatWasUndoneDuringTheRunIsDoneAtEarlierTicks() {
        CommandEdit only = execute(10, "box");
        markUndone(20, only);
        assertDoneAndUndone(null, only);
        assertEquals(List.of(), history.editsAhead());
        assertTrue(moveTo(19));
        assertDoneAndUndone(only, null);
        assertTrue(moveTo(20));
        assertDoneAndUndone(null, only);
        assertEquals(List.of(), history.editsAhead());
        assertEquals(10, history.firstTick(only));
        assertTrue(moveTo(15));
        assertEquals(new ForkedEdits(0, 1), history.fork(16));
        assertDoneAndUndone(only, null);
    }

    @Test
    void anEditThatIsUndoneAndRedoneLaterIsDoneAnyway() {
        CommandEdit only = execute(10, "box");
        markUndone(20, only);
        history.mark(only, true);
        history.addChange(30, only, true, results(30, redoCommands(only)));
        CommandEdit other = execute(40, "wall");
        markUndone(50, other);
        moveTo(15);
        assertEquals(new ForkedEdits(1, 0), history.fork(16));
        assertDoneAndUndone(only, other);
    }

    @Test
    void anEarlierCommandLeavesLaterEditsToTheUser() {
        CommandEdit first = execute(10, "box");
        CommandEdit second = execute(20, "wall");
        moveTo(12);
        assertEquals(new ForkedEdits(1, 0), history.fork(13));
        CommandEdit between = execute(13, "pole");
        assertDoneAndUndone(between, second);
        assertTrue(moveTo(12));
        assertDoneAndUndone(first, between);
        moveTo(100);
        assertDoneAndUndone(between, second);
        assertEquals(new ForkedEdits(0, 0), history.fork(101));
    }

    @Test
    void aCommandAtTheTickOfALaterEditIsBeforeIt() {
        CommandEdit first = execute(10, "box");
        moveTo(9);
        assertEquals(new ForkedEdits(1, 0), history.fork(10));
        assertDoneAndUndone(null, first);
    }

    @Test
    void aCommandWithoutEffectAlsoLeavesLaterEditsToTheUser() {
        CommandEdit first = execute(10, "box");
        CommandEdit second = execute(20, "wall");
        moveTo(12);
        assertEquals(new ForkedEdits(1, 0), history.fork(13));
        assertFalse(history.advanceTo(100));
        assertDoneAndUndone(first, second);
    }

    @Test
    void editsThatTheRunPassesBeforeACommandAreDone() {
        execute(10, "box");
        CommandEdit second = execute(20, "wall");
        moveTo(12);
        assertEquals(new ForkedEdits(0, 0), history.fork(21));
        assertDoneAndUndone(second, null);
    }

    @Test
    void aRestartIncludesAllEditsFromTheStart() {
        CommandEdit moved = execute(5, "box");
        switchOff(10, "front");
        CommandEdit last = switchOff(20, "left");
        List<List<Long>> ticks = new ArrayList<>();
        history.restart((edit, executed) -> replacement(ticks, executed));
        assertEquals(List.of(List.of(10L), List.of(20L)), ticks);
        assertEquals("edit 2", history.nextUndo().orElseThrow().name());
        assertTrue(history.nextRedo().isEmpty());
        assertFalse(moveTo(0));
        assertEquals("edit 2", history.nextUndo().orElseThrow().name());
        assertEquals(0, history.firstTick(moved));
        assertEquals(0, history.firstTick(last));
        history.clear();
        assertDoneAndUndone(null, null);
    }

    private SetupEdit replacement(List<List<Long>> ticks, List<CommandResult> executed) {
        ticks.add(executed.stream().map(CommandResult::tick).toList());
        return edit(ticks.size());
    }

    /** The edits of events leave the run, however it is moved afterwards; the others follow it. */
    @Test
    void aMoveBeforeAnEventPutsAllEventsOnTheTimeline() {
        switchOff(10, "front");
        CommandEdit moved = execute(20, "box");
        CommandEdit undone = switchOff(25, "rear");
        markUndone(27, undone);
        CommandEdit redone = switchOff(30, "left");
        markUndone(40, redone);
        history.mark(redone, true);
        history.addChange(50, redone, true, results(50, redoCommands(redone)));
        List<List<Long>> ticks = new ArrayList<>();
        assertTrue(history.moveTo(5, true, (edit, executed) -> replacement(ticks, executed)));
        assertEquals(List.of(List.of(10L), List.of(30L, 40L, 50L)), ticks);
        assertEquals("edit 2", history.nextUndo().orElseThrow().name());
        assertEquals(List.of(moved), history.editsAhead());
        assertEquals(Optional.of(moved), history.nextRedo());
        assertTrue(history.advanceTo(20));
        assertDoneAndUndone(moved, null);
        assertTrue(moveTo(19));
        assertEquals(new ForkedEdits(1, 0), history.fork(20));
        CommandEdit between = execute(20, "pole");
        assertDoneAndUndone(between, moved);
        history.mark(between, false);
        assertEquals("edit 2", history.nextUndo().orElseThrow().name());
    }

    /** An edit of the setup has no tick, so the run can be moved before the edit that it follows. */
    @Test
    void anEditBeforeAnEditOfTheSetupFollowsTheRun() {
        CommandEdit moved = execute(10, "box");
        SetupEdit setup = edit(nextGesture++);
        history.add(setup);
        assertTrue(moveTo(5));
        assertDoneAndUndone(setup, moved);
        assertTrue(history.advanceTo(10));
        assertDoneAndUndone(moved, null);
        history.mark(moved, false);
        assertDoneAndUndone(setup, moved);
    }

    private CommandEdit setRange(long tick, String sensor) {
        SensorSpec front = RobotSpec.DEFAULT.sensors().get(0).withId(sensor);
        return execute(tick, new Command.ConfigureSensor(front.withRange(1.5)), new Command.ConfigureSensor(front));
    }

    private List<String> sensors(CommandEdit edit) {
        return Stream.concat(redoCommands(edit).stream(), undoCommands(edit).stream())
                .flatMap(command -> SensorReference.in(command).stream())
                .distinct()
                .toList();
    }

    /** The commands of an edit have the ids of its place, so that undoing edits in their order finds their sensors. */
    @Test
    void anEditThatPassesARenamingHasTheNewIdAfterIt() {
        CommandEdit ranged = setRange(10, "left");
        SetupEdit renamed = new SetupEdit(
                () -> "rename",
                nextGesture++,
                SetupChange.of(() -> {}, () -> {}),
                List.of(Rename.ofSensor("left", "port"), Rename.ofSensor("port", "larboard")));
        history.add(renamed);
        assertEquals(List.of("left"), sensors(ranged), "before it");
        moveTo(5);
        assertDoneAndUndone(renamed, ranged);
        assertEquals(List.of("larboard"), sensors(ranged));
        history.mark(renamed, false);
        history.advanceTo(10);
        assertDoneAndUndone(ranged, renamed);
        assertEquals(List.of("left"), sensors(ranged));
        moveTo(5);
        assertEquals(List.of("left"), sensors(ranged), "a renaming that is undone was not passed");
        history.add(renamed);
        assertDoneAndUndone(renamed, ranged);
        assertEquals(List.of("larboard"), sensors(ranged), "a new renaming comes before what is ahead");
    }

    @Test
    void anEventDuringADragIsAnEditOfItsOwn() {
        CommandEdit moved = execute(10, "box");
        nextGesture--;
        CommandEdit switched = switchOff(10, "front");
        nextGesture--;
        CommandEdit movedOn = execute(11, "box");
        nextGesture--;
        execute(12, "box");
        assertDoneAndUndone(movedOn, null);
        history.mark(movedOn, false);
        assertDoneAndUndone(switched, movedOn);
        history.mark(switched, false);
        assertDoneAndUndone(moved, switched);
    }

    /** Returns the number of parts of a drag that stopped at the robot, given where it continued after the timeline. */
    private static int countParts(Command stopped, Command continuedFrom) {
        Command planned = new Command.MoveObstacle("box", new Pose(3, 3, 0));
        CommandEdit drag = new CommandEdit(
                1,
                List.of(new CommandResult.Executed(
                        10, planned, stopped, List.of(new Command.MoveObstacle("box", new Pose(1, 1, 0))))));
        Command next = new Command.MoveObstacle("box", new Pose(4, 4, 0));
        CommandEdit continued =
                new CommandEdit(1, List.of(new CommandResult.Executed(20, next, List.of(continuedFrom))));
        assertTrue(drag.merge(continued, tick -> List.of(planned)));
        return drag.results().size();
    }

    @Test
    void aDragContinuesWhereItsObstacleHasStopped() {
        Command stopped = new Command.MoveObstacle("box", new Pose(2, 2, 0));
        assertEquals(1, countParts(stopped, stopped), "the timeline has not moved it away");
        assertEquals(2, countParts(stopped, new Command.MoveObstacle("box", new Pose(3, 3, 0))));
    }
}
