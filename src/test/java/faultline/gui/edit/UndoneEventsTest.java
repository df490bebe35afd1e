package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TimelineEvents;
import faultline.gui.document.Workspace;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Faults and switches of a run, undone after a restart, when they are on the timeline. */
@ExtendWith(EdtChecker.class)
class UndoneEventsTest {

    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.13));

    private Workspace workspace;
    private RunController run;
    private UndoController edits;
    private Scenario original;

    @BeforeEach
    void open() {
        runOnEdt(() -> {
            workspace = new Workspace();
            run = new RunController(workspace);
            edits = StoppedClock.undoController(run::send);
            workspace.addListener(new UndoForwarder(run, edits));
            new DocumentStore(workspace).open(Path.of("scenarios/office.xml"));
        });
        SessionFrames.awaitScenario(workspace);
        original = scenario();
        advance(10);
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    private Scenario scenario() {
        return callOnEdt(() -> workspace.scenario().orElseThrow());
    }

    private List<TimedCommand> timeline() {
        return scenario().setup().timeline();
    }

    private void advance(int ticks) {
        long end = SessionFrames.tick(workspace) + ticks;
        for (int i = 0; i < ticks; i++) {
            runOnEdt(run::step);
        }
        SessionFrames.awaitTick(workspace, end);
        runOnEdt(() -> edits.runAdvanced(end));
    }

    private void send(Command command) {
        runOnEdt(() -> {
            edits.endEdit();
            edits.send(command);
        });
        rest();
    }

    private void undo() {
        runOnEdt(edits::undo);
        rest();
    }

    private void redo() {
        runOnEdt(edits::redo);
        rest();
    }

    private void restart() {
        runOnEdt(run::restart);
        rest();
    }

    private void rest() {
        Await.until(
                "the end of the edit",
                () -> !workspace.awaitsCommands() && workspace.task().isEmpty());
    }

    @Test
    void eventsAreUndoneBeforeTheirTimeInARestartedRun() {
        List<Command> events = List.of(
                FAULT,
                new Command.SwitchSensor("front", false),
                new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.Weak(0.5)));
        for (Command event : events) {
            send(event);
            advance(5);
        }
        Scenario edited = scenario();
        assertEquals(events, timeline().stream().map(TimedCommand::command).toList());
        restart();
        assertEquals(edited, scenario());
        for (int left = 2; left >= 0; left--) {
            undo();
            assertEquals(edited.setup().timeline().subList(0, left), timeline());
        }
        assertEquals(original, scenario());
        assertTrue(callOnEdt(edits::undoName).isEmpty());
        for (int i = 0; i < 3; i++) {
            redo();
        }
        assertEquals(edited, scenario());
    }

    /** The sensor is repaired at the present time in the first run, and has never been broken in the second one. */
    @Test
    void anEventThatIsUndoneAfterItsTimeIsNotOnTheTimelineAndTheRunIsSimulatedAgain() {
        send(FAULT);
        advance(5);
        restart();
        advance(30);
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
        long broken = SessionFrames.trajectoryHash(workspace);
        undo();
        SessionFrames.awaitTick(workspace, 30);
        assertEquals(List.of(), faults());
        assertEquals(original, scenario());
        assertTrue(broken != SessionFrames.trajectoryHash(workspace));
    }

    private List<Fault> faults() {
        return SessionFrames.frame(workspace).snapshot().sensors().stream()
                .flatMap(sensor -> sensor.faults().stream())
                .toList();
    }

    @Test
    void whatUndoAndRedoHaveAddedIsRemovedToo() {
        send(FAULT);
        advance(5);
        undo();
        advance(5);
        redo();
        advance(5);
        assertEquals(3, timeline().size());
        restart();
        undo();
        assertEquals(original, scenario());
    }

    /** The times on the timeline are those of the run before. */
    @Test
    void anotherLengthOfTheTickChangesNoTime() {
        send(FAULT);
        advance(5);
        runOnEdt(() -> run.change(now -> now.withSetup(now.setup().withTick(0.02))));
        rest();
        assertEquals(0.11, timeline().get(0).time());
        undo();
        assertEquals(original.setup().timeline(), timeline());
    }

    private void seek(long tick) {
        runOnEdt(() -> run.navigator().seek(tick));
        rest();
        SessionFrames.awaitTick(workspace, tick);
    }

    private void assertTimes(double... times) {
        assertArrayEquals(
                times, timeline().stream().mapToDouble(TimedCommand::time).toArray());
    }

    /** Whatever is done at the earlier tick, the fault keeps its time. */
    @Test
    void aLaterEventIsKeptWhenTheRunIsEditedAtAnEarlierTick() {
        send(FAULT);
        advance(5);
        seek(3);
        runOnEdt(() -> run.change(now -> now.withSetup(now.setup().withSeed(7))));
        rest();
        assertTimes(0.11);
        send(new Command.SwitchSensor("front", false));
        assertTimes(0.11, 0.04);
        advance(6);
        assertEquals(List.of(), faults());
        advance(5);
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
        undo();
        assertTimes(0.11, 0.04, 0.15);
        redo();
        undo();
        undo();
        undo();
        assertEquals(
                List.of(),
                timeline().stream()
                        .map(TimedCommand::command)
                        .filter(FAULT::equals)
                        .toList());
        assertEquals(List.of(), faults());
    }

    @Test
    void aMoveBeforeAnEventAndPastItAgainChangesNoBit() {
        send(FAULT);
        advance(5);
        send(new Command.SwitchSensor("front", false));
        advance(20);
        Scenario edited = scenario();
        long hash = SessionFrames.trajectoryHash(workspace);
        seek(3);
        assertEquals(edited, scenario());
        advance(32);
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
        seek(3);
        seek(35);
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
        assertEquals(edited, scenario());
    }

    @Test
    void undoAtAnEarlierTickRemovesTheLaterEvent() {
        send(FAULT);
        advance(5);
        seek(3);
        assertTrue(callOnEdt(edits::redoName).isEmpty());
        undo();
        assertEquals(original, scenario());
        advance(30);
        assertEquals(List.of(), faults());
        redo();
        assertTimes(0.11);
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
    }

    @Test
    void aMoveThatPassesNoEventLeavesThemInTheRun() {
        send(FAULT);
        advance(5);
        seek(12);
        undo();
        assertTimes(0.11, 0.13);
    }

    /** Undo sends all faults that the sensor had before. */
    @Test
    void aFaultThatIsUndoneInItsOwnTickLeavesNothing() {
        send(FAULT);
        undo();
        assertEquals(original, scenario());
        redo();
        assertTimes(0.11);
        send(new Command.InjectFault("left", new Fault.Stuck(0.3)));
        send(new Command.InjectMotorFault(MotorSide.RIGHT, new MotorFault.Weak(0.5)));
        assertTimes(0.11, 0.11, 0.11);
        undo();
        undo();
        assertEquals(
                List.of(FAULT), timeline().stream().map(TimedCommand::command).toList());
        undo();
        assertEquals(original, scenario());
    }

    private static final Command OFF = new Command.SwitchSensor("left", false);
    private static final Command ON = new Command.SwitchSensor("left", true);

    private void assertUndone(String name) {
        assertEquals(Optional.ofNullable(name), callOnEdt(edits::undoName));
    }

    /** Both are still commands of the run, which are executed and redone when it gets there. */
    @Test
    void eventsOfOneTickThatCancelOutCanBeUndoneWhenTheRunHasReachedThemAgain() {
        send(OFF);
        send(ON);
        advance(5);
        seek(3);
        assertUndone(null);
        assertEquals(original, scenario());
        advance(20);
        assertUndone("Switch left on");
        undo();
        assertTimes(0.24);
        assertFalse(isLeftOn());
        undo();
        assertEquals(original, scenario());
        assertTrue(isLeftOn());
    }

    private boolean isLeftOn() {
        return SessionFrames.frame(workspace)
                .snapshot()
                .robot()
                .sensor("left")
                .orElseThrow()
                .on();
    }

    /** The timeline has neither of them, so undoing one would have no effect. */
    @Test
    void eventsOfOneTickThatCancelOutCannotBeUndoneOnTheTimeline() {
        Command move = new Command.SwitchSensor("front", false);
        send(move);
        send(OFF);
        send(ON);
        send(FAULT);
        send(new Command.ClearFaults("left"));
        assertUndone("Repair left");
        restart();
        assertUndone("Switch front off");
        undo();
        assertEquals(original, scenario());
        assertUndone(null);
        redo();
        assertTimes(0.11);
        assertUndone("Switch front off");
    }

    @Test
    void eventsOfOneTickThatCancelOutCannotBeUndoneBeforeALaterEvent() {
        send(OFF);
        send(ON);
        advance(5);
        send(FAULT);
        seek(3);
        assertUndone("Fault in left");
        undo();
        assertEquals(original, scenario());
        assertUndone(null);
    }

    @Test
    void anEventThatIsPutOnTheTimelineAgainIsUndoneThere() {
        send(FAULT);
        advance(5);
        List<TimedCommand> events = timeline();
        runOnEdt(() -> run.change(now -> TimelineEvents.without(now, events)));
        rest();
        runOnEdt(() -> run.change(now -> TimelineEvents.with(now, events)));
        rest();
        assertTimes(0.11);
        seek(3);
        assertUndone("Fault in left");
        undo();
        assertEquals(original, scenario());
    }

    /** What was executed before the restart, or before the move back, is no longer part of the edit. */
    @Test
    void anEventThatIsRedoneAfterARestartAtThePresentTimeIsTheOneThatIsUndone() {
        send(FAULT);
        advance(5);
        undo();
        restart();
        advance(2);
        redo();
        assertTimes(0.11, 0.16, 0.03);
        advance(5);
        restart();
        undo();
        assertTimes(0.11, 0.16);
    }

    @Test
    void anEventThatIsRedoneAtAnEarlierTickIsTheOneThatIsUndone() {
        send(FAULT);
        advance(5);
        undo();
        advance(5);
        seek(3);
        redo();
        assertTimes(0.11, 0.16, 0.04);
        advance(2);
        seek(1);
        undo();
        assertTimes(0.11, 0.16);
    }
}
