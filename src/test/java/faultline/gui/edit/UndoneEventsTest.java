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
import faultline.gui.change.Rename;
import faultline.gui.change.TimelineEvents;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.SessionFrames;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Faults and switches of a run, undone after a restart, when they are on the timeline. */
@ExtendWith(EdtChecker.class)
class UndoneEventsTest {

    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.13));

    private EditedRun run;
    private Scenario original;

    @BeforeEach
    void open() {
        run = new EditedRun();
        original = run.scenario();
        run.advance(10);
    }

    @AfterEach
    void close() {
        run.close();
    }

    @Test
    void eventsAreUndoneBeforeTheirTimeInARestartedRun() {
        List<Command> events = List.of(
                FAULT,
                new Command.SwitchSensor("front", false),
                new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.Weak(0.5)));
        for (Command event : events) {
            run.send(event);
            run.advance(5);
        }
        Scenario edited = run.scenario();
        assertEquals(events, run.timeline().stream().map(TimedCommand::command).toList());
        run.restart();
        assertEquals(edited, run.scenario());
        for (int left = 2; left >= 0; left--) {
            run.undo();
            assertEquals(edited.setup().timeline().subList(0, left), run.timeline());
        }
        assertEquals(original, run.scenario());
        assertTrue(callOnEdt(run.edits()::undoName).isEmpty());
        for (int i = 0; i < 3; i++) {
            run.redo();
        }
        assertEquals(edited, run.scenario());
    }

    /** The fault and its repair, which both are on the timeline, change nothing without the first fault. */
    @Test
    void aRepairThatHadNoEffectWhenItWasRedoneIsNotTheEditBeforeAnother() {
        Command repair = new Command.ClearFaults("left");
        run.send(FAULT);
        run.restart();
        run.advance(20);
        run.send(repair);
        run.send(FAULT);
        run.seek(2);
        run.redo();
        run.advance(20);
        run.send(repair);
        run.advance(10);
        run.undo();
        run.undo();
        assertEquals(original, run.scenario());
        assertFalse(callOnEdt(run.edits()::canUndo));
    }

    /** The sensor is repaired at the present time in the first run, and has never been broken in the second one. */
    @Test
    void anEventThatIsUndoneAfterItsTimeIsNotOnTheTimelineAndTheRunIsSimulatedAgain() {
        run.send(FAULT);
        run.advance(5);
        run.restart();
        run.advance(30);
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
        long broken = SessionFrames.trajectoryHash(run.workspace());
        run.undo();
        SessionFrames.awaitTick(run.workspace(), 30);
        assertEquals(List.of(), faults());
        assertEquals(original, run.scenario());
        assertTrue(broken != SessionFrames.trajectoryHash(run.workspace()));
    }

    /** The undo waits for the answer to the edit, and the file for that to the undo. */
    @Test
    void aSaveRightAfterAnUndoIsWithoutTheEdit(@TempDir Path folder) throws ScenarioException {
        Path file = folder.resolve("saved.xml");
        AtomicBoolean saved = new AtomicBoolean();
        runOnEdt(() -> {
            run.sender().send(FAULT);
            run.edits().undo();
            new DocumentStore(run.workspace()).save(file, () -> saved.set(true));
        });
        Await.until("the save", saved::get);
        run.rest();
        assertEquals(run.scenario(), Scenario.load(file));
        assertFalse(callOnEdt(run.workspace()::isChanged));
    }

    private List<Fault> faults() {
        return SessionFrames.frame(run.workspace()).snapshot().sensors().stream()
                .flatMap(sensor -> sensor.faults().stream())
                .toList();
    }

    @Test
    void whatUndoAndRedoHaveAddedIsRemovedToo() {
        run.send(FAULT);
        run.advance(5);
        run.undo();
        run.advance(5);
        run.redo();
        run.advance(5);
        assertEquals(3, run.timeline().size());
        run.restart();
        run.undo();
        assertEquals(original, run.scenario());
    }

    /** The times on the timeline are those of the run before. */
    @Test
    void anotherLengthOfTheTickChangesNoTime() {
        run.send(FAULT);
        run.advance(5);
        runOnEdt(() -> run.controller().change(now -> now.withSetup(now.setup().withTick(0.02))));
        run.rest();
        assertEquals(0.11, run.timeline().get(0).time());
        run.undo();
        assertEquals(original.setup().timeline(), run.timeline());
    }

    private void assertTimes(double... times) {
        assertArrayEquals(
                times, run.timeline().stream().mapToDouble(TimedCommand::time).toArray());
    }

    /** Whatever is done at the earlier tick, the fault keeps its time. */
    @Test
    void aLaterEventIsKeptWhenTheRunIsEditedAtAnEarlierTick() {
        run.send(FAULT);
        run.advance(5);
        run.seek(3);
        runOnEdt(() -> run.controller().change(now -> now.withSetup(now.setup().withSeed(7))));
        run.rest();
        assertTimes(0.11);
        run.send(new Command.SwitchSensor("front", false));
        assertTimes(0.11, 0.04);
        run.advance(6);
        assertEquals(List.of(), faults());
        run.advance(5);
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
        run.undo();
        assertTimes(0.11, 0.04, 0.15);
        run.redo();
        run.undo();
        run.undo();
        run.undo();
        assertEquals(
                List.of(),
                run.timeline().stream()
                        .map(TimedCommand::command)
                        .filter(FAULT::equals)
                        .toList());
        assertEquals(List.of(), faults());
    }

    @Test
    void aMoveBeforeAnEventAndPastItAgainChangesNoBit() {
        run.send(FAULT);
        run.advance(5);
        run.send(new Command.SwitchSensor("front", false));
        run.advance(20);
        Scenario edited = run.scenario();
        long hash = SessionFrames.trajectoryHash(run.workspace());
        run.seek(3);
        assertEquals(edited, run.scenario());
        run.advance(32);
        assertEquals(hash, SessionFrames.trajectoryHash(run.workspace()));
        run.seek(3);
        run.seek(35);
        assertEquals(hash, SessionFrames.trajectoryHash(run.workspace()));
        assertEquals(edited, run.scenario());
    }

    @Test
    void undoAtAnEarlierTickRemovesTheLaterEvent() {
        run.send(FAULT);
        run.advance(5);
        run.seek(3);
        assertTrue(callOnEdt(run.edits()::redoName).isEmpty());
        run.undo();
        assertEquals(original, run.scenario());
        run.advance(30);
        assertEquals(List.of(), faults());
        run.redo();
        assertTimes(0.11);
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
    }

    @Test
    void aMoveThatPassesNoEventLeavesThemInTheRun() {
        run.send(FAULT);
        run.advance(5);
        run.seek(12);
        run.undo();
        assertTimes(0.11, 0.13);
    }

    /** Undo sends all faults that the sensor had before. */
    @Test
    void aFaultThatIsUndoneInItsOwnTickLeavesNothing() {
        run.send(FAULT);
        run.undo();
        assertEquals(original, run.scenario());
        run.redo();
        assertTimes(0.11);
        run.send(new Command.InjectFault("left", new Fault.Stuck(0.3)));
        run.send(new Command.InjectMotorFault(MotorSide.RIGHT, new MotorFault.Weak(0.5)));
        assertTimes(0.11, 0.11, 0.11);
        run.undo();
        run.undo();
        assertEquals(
                List.of(FAULT),
                run.timeline().stream().map(TimedCommand::command).toList());
        run.undo();
        assertEquals(original, run.scenario());
    }

    @Test
    void eventsOfASensorAreUndoneAfterItsDeletionHasBeenUndone() {
        run.send(FAULT);
        run.send(OFF);
        run.advance(5);
        run.send(new Command.ClearFaults("left"));
        run.send(ON);
        run.advance(5);
        run.undo();
        run.undo();
        run.advance(5);
        Scenario edited = run.scenario();
        run.removeSensor("left");
        run.undo();
        assertEquals(edited, run.scenario());
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
        assertUndone("Switch left off");
        run.undo();
        assertTrue(isLeftOn());
        run.undo();
        assertEquals(List.of(), faults());
        assertEquals(original, run.scenario());
        run.redo();
        run.redo();
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
        assertFalse(isLeftOn());
    }

    private static final Command OFF = new Command.SwitchSensor("left", false);
    private static final Command ON = new Command.SwitchSensor("left", true);

    private void assertUndone(String name) {
        assertEquals(Optional.ofNullable(name), callOnEdt(run.edits()::undoName));
    }

    /** Both are still commands of the run, which are executed and redone when it gets there. */
    @Test
    void eventsOfOneTickThatCancelOutCanBeUndoneWhenTheRunHasReachedThemAgain() {
        run.send(OFF);
        run.send(ON);
        run.advance(5);
        run.seek(3);
        assertUndone(null);
        assertEquals(original, run.scenario());
        run.advance(20);
        assertUndone("Switch left on");
        run.undo();
        assertTimes(0.24);
        assertFalse(isLeftOn());
        run.undo();
        assertEquals(original, run.scenario());
        assertTrue(isLeftOn());
    }

    private boolean isLeftOn() {
        return SessionFrames.frame(run.workspace())
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
        run.send(move);
        run.send(OFF);
        run.send(ON);
        run.send(FAULT);
        run.send(new Command.ClearFaults("left"));
        assertUndone("Repair left");
        run.restart();
        assertUndone("Switch front off");
        run.undo();
        assertEquals(original, run.scenario());
        assertUndone(null);
        run.redo();
        assertTimes(0.11);
        assertUndone("Switch front off");
    }

    @Test
    void eventsOfOneTickThatCancelOutCannotBeUndoneBeforeALaterEvent() {
        run.send(OFF);
        run.send(ON);
        run.advance(5);
        run.send(FAULT);
        run.seek(3);
        assertUndone("Fault in left");
        run.undo();
        assertEquals(original, run.scenario());
        assertUndone(null);
    }

    @Test
    void anEventThatIsPutOnTheTimelineAgainIsUndoneThere() {
        run.send(FAULT);
        run.advance(5);
        List<TimedCommand> events = run.timeline();
        runOnEdt(() -> run.controller().change(now -> TimelineEvents.without(now, events)));
        run.rest();
        runOnEdt(() -> run.controller().change(now -> TimelineEvents.with(now, events)));
        run.rest();
        assertTimes(0.11);
        run.seek(3);
        assertUndone("Fault in left");
        run.undo();
        assertEquals(original, run.scenario());
    }

    /** The scenario without the event, whose sensor gets another id, is not one that never had it. */
    @Test
    void anEventThatIsPutOnTheTimelineAgainAfterARenamingIsUndoneThere() {
        run.send(FAULT);
        run.advance(5);
        List<TimedCommand> events = run.timeline();
        runOnEdt(() -> run.controller().change(now -> TimelineEvents.without(now, events)));
        run.rest();
        runOnEdt(() -> run.controller().rename(Rename.ofSensor("front", "nose")));
        run.rest();
        runOnEdt(() -> run.controller().change(now -> TimelineEvents.with(now, events)));
        run.rest();
        run.seek(3);
        assertUndone("Fault in left");
        run.undo();
        assertEquals(List.of(), run.timeline());
    }

    /** The move undoes no edit, but puts all events on the timeline, which lacks those that cancel each other. */
    @Test
    void theNameOfTheNextUndoIsShownWhenEventsHaveBecomeCommandsOfTheTimeline() {
        run.send(FAULT);
        run.advance(5);
        run.send(OFF);
        run.send(ON);
        run.advance(5);
        assertEquals(Optional.of("Switch left on"), run.shownUndo());
        run.seek(3);
        assertEquals(Optional.of("Fault in left"), run.shownUndo());
    }

    /** What was executed before the restart, or before the move back, is no longer part of the edit. */
    @Test
    void anEventThatIsRedoneAfterARestartAtThePresentTimeIsTheOneThatIsUndone() {
        run.send(FAULT);
        run.advance(5);
        run.undo();
        run.restart();
        run.advance(2);
        run.redo();
        assertTimes(0.11, 0.16, 0.03);
        run.advance(5);
        run.restart();
        run.undo();
        assertTimes(0.11, 0.16);
    }

    @Test
    void anEventThatIsRedoneAtAnEarlierTickIsTheOneThatIsUndone() {
        run.send(FAULT);
        run.advance(5);
        run.undo();
        run.advance(5);
        run.seek(3);
        run.redo();
        assertTimes(0.11, 0.16, 0.04);
        run.advance(2);
        run.seek(1);
        run.undo();
        assertTimes(0.11, 0.16);
    }

    /** The repair and its undo have left the fault as it was, so they are removed with it. */
    @Test
    void anUndoneRepairIsRemovedWithItsFault() {
        sendRepairAndUndoIt();
        run.restart();
        assertFaultIsUndoneAndRedone();
    }

    @Test
    void anUndoneRepairIsRemovedWithItsFaultAfterAMove() {
        sendRepairAndUndoIt();
        run.seek(5);
        assertFaultIsUndoneAndRedone();
    }

    /** The fault is on the timeline already when the repair is. */
    @Test
    void anUndoneRepairIsRemovedWithAFaultOfAnEarlierRun() {
        run.send(FAULT);
        run.advance(5);
        run.seek(5);
        run.advance(10);
        run.send(new Command.ClearFaults("left"));
        run.advance(5);
        run.undo();
        run.advance(5);
        run.seek(5);
        assertFaultIsUndoneAndRedone();
    }

    /** A new edit, which the fault before it does not own, leaves the undone repair to the fault. */
    @Test
    void anUndoneRepairIsNotRemovedWithALaterFault() {
        sendRepairAndUndoIt();
        run.send(new Command.InjectFault("left", new Fault.Bias(0.1)));
        run.advance(5);
        run.restart();
        run.undo();
        assertEquals(3, run.timeline().size());
        assertFaultIsUndoneAndRedone();
    }

    @Test
    void anUndoneRepairIsRemovedWithAFaultThatIsOnTheTimeline() {
        run.send(FAULT);
        run.restart();
        run.advance(20);
        run.send(new Command.ClearFaults("left"));
        run.advance(5);
        run.undo();
        run.advance(5);
        assertFaultIsUndoneAndRedone();
    }

    @Test
    void aRepairThatIsRedoneWithoutEffectIsPassedOver() {
        sendRepairAndUndoIt();
        run.restart();
        run.redo();
        assertEquals(Optional.of("Fault in left"), callOnEdt(run.edits()::undoName));
        run.undo();
        assertEquals(List.of(), run.timeline());
    }

    /** Each fault takes the part of the repair that is about its sensor. */
    @Test
    void anUndoneRepairOfTwoSensorsIsRemovedWithTheirFaults() {
        run.send(FAULT);
        run.advance(5);
        run.send(new Command.InjectFault("front", new Fault.Stuck(0.13)));
        run.restart();
        run.advance(20);
        run.send(new Command.ClearFaults("left"), new Command.ClearFaults("front"));
        run.advance(5);
        run.undo();
        assertEquals(6, run.timeline().size());
        run.undo();
        assertEquals(3, run.timeline().size());
        assertFaultIsUndoneAndRedone();
    }

    /** Both events of the tick cancel out, so the fault is that of the first edit. */
    @Test
    void aFaultThatReplacesAnUndoneOneAtItsTickIsUndone() {
        run.send(FAULT);
        run.advance(5);
        run.undo();
        run.send(FAULT);
        assertEquals(1, run.timeline().size());
        run.restart();
        run.undo();
        assertEquals(List.of(), run.timeline());
    }

    /** The new edit has dropped the undone one, which is in effect again before the tick of its undo. */
    @Test
    void anUndoneFaultCanBeUndoneAgainBeforeThatTick() {
        run.send(FAULT);
        run.advance(5);
        run.undo();
        run.send(FAULT);
        run.seek(12);
        run.send(new Command.SwitchSensor("front", false));
        run.undo();
        run.undo();
        run.advance(1);
        assertEquals(List.of(), faults());
    }

    private void sendRepairAndUndoIt() {
        run.send(FAULT);
        run.advance(5);
        run.send(new Command.ClearFaults("left"));
        run.advance(5);
        run.undo();
        run.advance(5);
    }

    private void assertFaultIsUndoneAndRedone() {
        assertEquals(Optional.of("Fault in left"), callOnEdt(run.edits()::undoName));
        run.undo();
        assertEquals(List.of(), run.timeline());
        run.advanceTo(40);
        assertEquals(List.of(), faults());
        run.redo();
        run.advanceTo(50);
        assertEquals(List.of(new Fault.Stuck(0.13)), faults());
        assertEquals(3, run.timeline().size());
    }

    /** The repair and its undo are about the fault, whatever the sensor was called then. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aRepairUnderAnotherIdThatIsUndoneEndsWithItsFault(boolean faultIsPlanned) {
        run.send(FAULT);
        run.advance(5);
        if (faultIsPlanned) {
            run.restart();
            run.advance(30);
        }
        SensorEditor sensors = callOnEdt(
                () -> new SensorEditor(run.workspace(), new ScenarioEditor(run.controller(), run.edits()), note -> {}));
        runOnEdt(() -> sensors.rename("left", "nine"));
        run.rest();
        run.send(new Command.ClearFaults("nine"));
        run.advance(5);
        run.undo();
        run.advance(5);
        run.undo();
        if (!faultIsPlanned) {
            run.restart();
        }
        run.undo();
        assertEquals(original, run.scenario());
        run.advanceTo(60);
        assertEquals(List.of(), faults());
    }

    private void rename(String before, String after) {
        SensorEditor sensors = callOnEdt(
                () -> new SensorEditor(run.workspace(), new ScenarioEditor(run.controller(), run.edits()), note -> {}));
        runOnEdt(() -> sensors.rename(before, after));
        run.rest();
    }

    /** The id under which the repair was made is that of another sensor before and after. */
    @Test
    void aRepairUnderAFormerIdOfAnotherSensorThatIsUndoneEndsWithItsFault() {
        run.send(FAULT);
        rename("front", "b");
        run.restart();
        rename("left", "front");
        run.send(new Command.ClearFaults("front"));
        run.advance(7);
        for (int i = 0; i < 4; i++) {
            run.undo();
        }
        assertEquals(original, run.scenario());
        run.advanceTo(20);
        assertEquals(List.of(), faults());
    }

    /** The fault has the id that the sensor had before its renaming was undone. */
    @Test
    void aFaultThatTheTimelineHasEndedIsNotUndoneAfterARenaming() {
        runOnEdt(() -> run.controller()
                .change(now -> now.withSetup(
                        now.setup().withTimeline(List.of(new TimedCommand(0.3, new Command.ClearFaults("front")))))));
        run.rest();
        rename("front", "b");
        run.send(new Command.InjectFault("b", new Fault.Stuck(0.13)));
        run.advanceTo(40);
        run.undo();
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        assertEquals(List.of(), faults());
    }

    /** The fault has no effect after the repair, but when that is undone. */
    @Test
    void aFaultBeforeAPlannedRepairIsKeptWhenTheRepairIsUndone() {
        run.advanceTo(20);
        run.send(FAULT);
        run.send(new Command.InjectFault("left", new Fault.Bias(0.1)));
        run.advanceTo(30);
        run.send(new Command.ClearFaults("left"));
        run.restart();
        run.advanceTo(5);
        run.send(new Command.InjectFault("left", new Fault.Dead()));
        run.advanceTo(40);
        run.undo();
        run.advanceTo(41);
        assertEquals(
                List.of(new Fault.Dead(), new Fault.Stuck(0.13), new Fault.Bias(0.1)),
                faults(),
                callOnEdt(run.edits()::redoName).toString());
    }

    /** A fault and its repair at one time change nothing, so they are not those that the timeline has for that time. */
    @Test
    void aFaultThatIsRepairedAtOnceIsNotThePlannedOneOfItsTime() {
        List<TimedCommand> planned = List.of(new TimedCommand(0.11, FAULT));
        runOnEdt(() -> run.controller().change(now -> now.withSetup(now.setup().withTimeline(planned))));
        run.rest();
        run.send(FAULT);
        run.send(new Command.ClearFault("left", new Fault.Stuck(0.13)));
        run.restart();
        run.undo();
        assertEquals(planned, run.timeline());
    }

    /** The fault and its repair cancelled out, so what was undone later belongs to the fault before them. */
    @Test
    void anUndoneRepairEndsWithTheFaultBeforeEditsThatCancelledOut() {
        run.send(FAULT);
        run.advance(5);
        run.send(new Command.ClearFaults("left"));
        run.send(FAULT);
        run.restart();
        run.advance(20);
        run.send(new Command.ClearFaults("left"));
        run.advance(5);
        run.undo();
        run.undo();
        assertEquals(original, run.scenario());
    }
}
