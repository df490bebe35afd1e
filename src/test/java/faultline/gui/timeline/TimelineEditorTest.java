package faultline.gui.timeline;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.EdtChecker;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.EditedRun;
import faultline.gui.edit.UndoController;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Edits of the timeline among commands of the run. */
@ExtendWith(EdtChecker.class)
class TimelineEditorTest {

    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.13));
    private static final TimedCommand SWITCH = new TimedCommand(5, new Command.SwitchSensor("right", false));

    private final EditedRun edited = new EditedRun();
    private final Workspace workspace = edited.workspace();
    private final RunController run = edited.controller();
    private final CommandSender sender = edited.sender();
    private final UndoController undo = edited.edits();
    private final TimelineEditor timeline = callOnEdt(() -> new TimelineEditor(workspace, run, undo, note -> {}));

    @AfterEach
    void close() {
        edited.close();
    }

    private List<TimedCommand> commands() {
        return callOnEdt(() -> timeline.model().commands());
    }

    private void edit(Runnable edit) {
        runOnEdt(edit);
        edited.rest();
    }

    /** The fault is on the timeline since the run was moved before it, so it precedes the switch. */
    @Test
    void anEventOfTheRunIsAnItemAmongOthersWhenTheRunHasBeenMovedBeforeIt() {
        edited.advanceTo(20);
        edit(() -> sender.send(FAULT));
        TimedCommand fault = commands().get(0);
        edited.advanceTo(30);
        edit(() -> run.navigator().seek(15));
        SessionFrames.awaitTick(workspace, 15);
        edit(() -> timeline.add(TimelineItem.from(SWITCH.command(), SWITCH.time()), null));
        edited.advanceTo(40);
        edit(run::restart);
        assertEquals(List.of(fault, SWITCH), commands());
        edit(undo::undo);
        assertEquals(List.of(fault), commands());
        edit(undo::undo);
        assertEquals(List.of(), commands());
        edit(undo::redo);
        assertEquals(List.of(fault), commands());
        edit(undo::redo);
        assertEquals(List.of(fault, SWITCH), commands());
    }

    /** The run executes the timeline's commands of a tick before the fault, which the repair would remove otherwise. */
    @Test
    void commandsOfOneTimeKeepTheirOrderWhenAllStepsAreUndoneAndRedone() {
        edited.advanceTo(10);
        edit(() -> sender.send(FAULT));
        TimedCommand fault = commands().get(0);
        TimedCommand repair = new TimedCommand(fault.time(), new Command.ClearFaults("left"));
        edit(() -> timeline.add(TimelineItem.from(repair.command(), repair.time()), null));
        assertEquals(List.of(repair, fault), commands());
        edit(run::restart);
        edit(undo::undo);
        edit(undo::undo);
        assertEquals(List.of(), commands());
        edit(undo::redo);
        edit(undo::redo);
        assertEquals(List.of(repair, fault), commands());
    }

    @Test
    void repeatedChangesOfAnItemAreUndoneAndRedoneAtOnce() {
        TimelineItem fault = new TimelineItem(FAULT, 20, 40);
        edit(() -> timeline.add(fault, null));
        List<TimedCommand> before = commands();
        edit(() -> timeline.replace(0, fault.withTimes(20.2, 40.2)));
        edit(() -> timeline.replace(0, fault.withTimes(20.4, 40.2)));
        edit(() -> timeline.replace(0, fault.withTimes(20.4, Double.POSITIVE_INFINITY)));
        List<TimedCommand> after = commands();
        for (int i = 0; i < 2; i++) {
            edit(undo::undo);
            assertEquals(before, commands());
            assertEquals(fault, callOnEdt(timeline::takeRestored).orElseThrow());
            edit(undo::redo);
            assertEquals(after, commands());
        }
        edit(undo::undo);
        edit(undo::undo);
        assertEquals(List.of(), commands());
    }

    /** The first item gets the index of the second one, which gets that of the first. */
    @Test
    void quickChangesOfTwoItemsThatChangePlacesAreTwoEdits() {
        TimelineItem fault = new TimelineItem(FAULT, 20, 30);
        TimelineItem off = TimelineItem.from(SWITCH.command(), 40);
        edit(() -> timeline.add(fault, null));
        edit(() -> timeline.add(off, null));
        List<TimedCommand> before = commands();
        edit(() -> timeline.replace(0, fault.withTimes(50, 60)));
        List<TimedCommand> between = commands();
        edit(() -> timeline.replace(0, off.withTimes(41, off.end())));
        edit(undo::undo);
        assertEquals(between, commands());
        edit(undo::undo);
        assertEquals(before, commands());
    }

    @Test
    void quickChangesOfAnItemWhoseIndexChangesAreOneEdit() {
        TimelineItem fault = new TimelineItem(FAULT, 20, 30);
        edit(() -> timeline.add(fault, null));
        edit(() -> timeline.add(TimelineItem.from(SWITCH.command(), 40), null));
        List<TimedCommand> before = commands();
        edit(() -> timeline.replace(0, fault.withTimes(50, 60)));
        edit(() -> timeline.replace(1, fault.withTimes(52, 60)));
        edit(undo::undo);
        assertEquals(before, commands());
    }

    @Test
    void theRemovalOfAnItemThatWasJustAddedIsAnEditOfItsOwn() {
        TimelineItem off = TimelineItem.from(SWITCH.command(), 40);
        edit(() -> timeline.add(off, null));
        edit(() -> timeline.remove(0));
        edit(undo::undo);
        assertEquals(
                List.of(SWITCH.command()),
                commands().stream().map(TimedCommand::command).toList());
    }
}
