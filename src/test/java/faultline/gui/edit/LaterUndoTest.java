package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.HeadlessRun;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.sensor.Fault;
import faultline.sensor.SignalFault;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Events that are undone after the timeline has changed what they are about. */
@ExtendWith(EdtChecker.class)
class LaterUndoTest {

    private static final Fault DRIFT = new SignalFault.Drift(0.01);
    private static final Fault BIAS = new Fault.Bias(0.1);
    private static final Fault STUCK = new Fault.Stuck(0.4);
    private static final MotorFault WEAK = new MotorFault.Weak(0.9);
    private static final MotorFault WEAKER = new MotorFault.Weak(0.8);

    private EditedRun run;

    @BeforeEach
    void open() {
        run = new EditedRun();
    }

    @AfterEach
    void close() {
        run.close();
    }

    private static TimedCommand at(double seconds, Command command) {
        return new TimedCommand(seconds, command);
    }

    /** Plans a drift of the front sensor and weak motors from 0.12 s to 0.40 s, and more. */
    private void plan(TimedCommand... more) {
        List<TimedCommand> timeline = new ArrayList<>(List.of(
                at(0.12, new Command.InjectFault("front", DRIFT)),
                at(0.12, new Command.InjectMotorFault(MotorSide.LEFT, WEAK)),
                at(0.40, new Command.ClearFault("front", DRIFT)),
                at(0.40, new Command.ClearMotorFault(MotorSide.LEFT, WEAK))));
        timeline.addAll(List.of(more));
        runOnEdt(() -> run.controller().change(now -> now.withSetup(now.setup().withTimeline(timeline))));
        run.rest();
    }

    /** Checks the faults of the front sensor in the next tick, and that the edited scenario leads to the same run. */
    private void assertFaults(Fault... expected) {
        run.advanceTo(run.tick() + 1);
        assertEquals(
                List.of(expected),
                SessionFrames.frame(run.workspace()).snapshot().sensors().stream()
                        .filter(sensor -> sensor.spec().id().equals("front"))
                        .findFirst()
                        .orElseThrow()
                        .faults());
        assertSameRun();
    }

    private void assertMotorFaults(MotorFault... expected) {
        run.advanceTo(run.tick() + 1);
        assertEquals(
                List.of(expected),
                SessionFrames.frame(run.workspace()).snapshot().motorFaults().left());
        assertSameRun();
    }

    private void assertSameRun() {
        Scenario edited = run.scenario();
        long ticks = run.tick();
        SimulationSetup setup = edited.setup().withDuration(edited.setup().timeOf(ticks));
        assertEquals(
                HeadlessRun.run(setup, ControllerMode.DIRECT, List.of()).trajectoryHash(),
                SessionFrames.trajectoryHash(run.workspace()));
    }

    /** The timeline injects the same fault again and repairs it once, though its file has the repair first. */
    @Test
    void theTimelineIsFollowedInTheOrderOfItsTimes() {
        plan(at(0.30, new Command.ClearFault("front", BIAS)), at(0.20, new Command.InjectFault("front", BIAS)));
        run.advanceTo(15);
        run.send(new Command.InjectFault("front", BIAS));
        run.advanceTo(35);
        assertFaults(DRIFT, BIAS);
        run.undo();
        assertFaults(DRIFT);
    }

    @Test
    void aFaultThatHasEndedDoesNotReturn() {
        plan();
        run.advanceTo(29);
        run.send(new Command.InjectFault("front", STUCK));
        run.advanceTo(52);
        run.undo();
        assertFaults();
        run.redo();
        assertFaults(STUCK);
        run.undo();
        assertFaults();
    }

    @Test
    void aFaultThatHasBegunContinues() {
        plan(at(0.45, new Command.InjectFault("front", BIAS)));
        run.advanceTo(29);
        run.send(new Command.InjectFault("front", STUCK));
        run.advanceTo(52);
        run.undo();
        assertFaults(BIAS);
    }

    @Test
    void aRepairedFaultReturnsOnlyUntilItsEnd() {
        plan();
        run.advanceTo(29);
        run.send(new Command.ClearFault("front", DRIFT));
        run.advanceTo(34);
        run.undo();
        assertFaults(DRIFT);
        run.advanceTo(41);
        assertFaults();
    }

    @Test
    void aRepairIsPassedOverAfterTheEndOfTheFault() {
        plan(at(0.45, new Command.InjectFault("front", BIAS)));
        run.advanceTo(20);
        run.send(new Command.SwitchSensor("left", false));
        run.advanceTo(29);
        run.send(new Command.ClearFaults("front"));
        assertEquals("Repair front", callOnEdt(() -> run.edits().undoName().orElseThrow()));
        run.advanceTo(52);
        assertEquals("Switch left off", callOnEdt(() -> run.edits().undoName().orElseThrow()));
        run.undo();
        assertFaults(BIAS);
        assertEquals("Switch left off", callOnEdt(() -> run.edits().redoName().orElseThrow()));
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
    }

    @Test
    void aFaultThatIsRedoneAfterItsEndIsUndoneAgain() {
        plan(at(0.45, new Command.ClearFaults("front")));
        run.advanceTo(29);
        run.send(new Command.InjectFault("front", STUCK));
        run.advanceTo(35);
        run.undo();
        run.advanceTo(52);
        run.redo();
        assertFaults(STUCK);
        run.advanceTo(60);
        run.undo();
        assertFaults();
    }

    @Test
    void aSwitchThatIsRedoneAfterALaterOneIsUndoneAgain() {
        plan(at(0.45, new Command.SwitchSensor("front", false)), at(0.5, new Command.SwitchSensor("front", true)));
        run.advanceTo(29);
        run.send(new Command.SwitchSensor("front", false));
        run.advanceTo(35);
        run.undo();
        run.advanceTo(52);
        run.redo();
        run.advanceTo(60);
        assertEquals("Switch front off", callOnEdt(() -> run.edits().undoName().orElseThrow()));
        run.undo();
        run.advanceTo(61);
        assertSameRun();
        assertTrue(isFrontOn());
    }

    private boolean isFrontOn() {
        return SessionFrames.frame(run.workspace())
                .snapshot()
                .sensors()
                .get(0)
                .spec()
                .on();
    }

    /** The timeline that the scenario has got by a move that was cancelled is not that of the run. */
    @Test
    void eventsAreUndoneAfterACancelledMoveAsBefore() {
        plan();
        run.advanceTo(50);
        run.send(new Command.InjectFault("front", STUCK));
        run.advanceTo(60);
        run.send(new Command.ClearFaults("front"));
        run.advanceTo(70);
        run.undo();
        run.advanceTo(80);
        runOnEdt(() -> {
            run.controller().navigator().seek(10);
            run.workspace().cancelTask();
        });
        Await.until(
                "the events on the timeline",
                () -> run.workspace()
                                .scenario()
                                .orElseThrow()
                                .setup()
                                .timeline()
                                .size()
                        == 7);
        run.undo();
        assertFaults();
    }

    @Test
    void faultsOfMotorsAreUndoneInTheSameWay() {
        plan();
        run.advanceTo(29);
        run.send(new Command.InjectMotorFault(MotorSide.LEFT, WEAKER));
        run.advanceTo(52);
        run.undo();
        assertMotorFaults();
    }

    @Test
    void aSwitchIsUndoneWithoutEffectAfterALaterOne() {
        plan(at(0.45, new Command.SwitchSensor("front", false)));
        run.advanceTo(29);
        run.send(new Command.SwitchSensor("front", false));
        run.advanceTo(52);
        run.undo();
        assertSameRun();
        assertFalse(isFrontOn());
    }

    /** What was undone is removed from the timeline, too. */
    @Test
    void anUndoneFaultIsNotOnTheTimelineAfterAMoveBack() {
        plan();
        run.advanceTo(29);
        run.send(new Command.InjectFault("front", STUCK));
        run.advanceTo(52);
        run.undo();
        run.redo();
        run.advanceTo(55);
        run.seek(10);
        run.undo();
        assertEquals(4, run.timeline().size());

        run.advanceTo(60);
        assertFaults();
    }

    /** Without the plan, the sensor is on all the time, and the fault has never been there. */
    @Test
    void eventsThatChangeNothingWithoutThePlanAreNotUndoneAfterIt() {
        Scenario first = run.scenario();
        run.planWithUndo(
                at(0.05, new Command.SwitchSensor("front", false)),
                at(0.05, new Command.InjectFault("front", BIAS)),
                at(0.15, new Command.SwitchSensor("front", true)),
                at(0.15, new Command.ClearFaults("front")));
        run.advanceTo(10);
        run.send(new Command.SwitchSensor("front", true));
        run.send(new Command.ClearFault("front", BIAS));
        run.advanceTo(21);
        Scenario edited = run.scenario();
        run.undo();
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        assertEquals(first, run.scenario());
        assertFaults();
        run.redo();
        assertEquals(edited, run.scenario());
        assertFaults();
        run.undo();
        assertEquals(first, run.scenario());
    }

    /** Nothing could undo it. */
    @Test
    void aRepairThatChangedNothingChangesNothingWithoutThePlanEither() {
        run.planWithUndo(at(0.05, new Command.ClearFaults("front")));
        run.send(new Command.InjectFault("front", BIAS));
        run.advanceTo(10);
        run.send(new Command.ClearFaults("front"));
        run.undo();
        assertFaults(BIAS);
    }

    /** The plan is what has ended the fault. */
    @Test
    void aFaultThatThePlanHasEndedIsUndoneAfterThePlan() {
        Scenario first = run.scenario();
        run.planWithUndo(at(0.05, new Command.InjectFault("front", STUCK)), at(0.15, new Command.ClearFaults("front")));
        run.advanceTo(10);
        run.send(new Command.ClearFaults("front"));
        run.send(new Command.InjectFault("front", BIAS));
        run.advanceTo(21);
        run.undo();
        assertFaults(BIAS);
        run.undo();
        assertFaults();
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
        run.restart();
        run.advanceTo(30);
        assertFaults();
    }

    private static final Command ON = new Command.SwitchSensor("front", true);
    private static final Command OFF = new Command.SwitchSensor("front", false);

    @Test
    void theUndoOfASwitchHasNoEffectWithoutThePlanThatTheSwitchChanged() {
        Scenario first = run.scenario();
        run.planWithUndo(at(0.05, OFF), at(0.05, new Command.InjectFault("front", BIAS)));
        run.advanceTo(10);
        run.send(ON);
        run.send(new Command.ClearFaults("front"));
        run.advanceTo(20);
        run.undo();
        run.undo();
        run.advanceTo(30);
        Scenario undone = run.scenario();
        assertFaults(BIAS);
        run.undo();
        assertEquals(first, run.scenario());
        assertFaults();
        run.redo();
        assertEquals(undone, run.scenario());
        assertFaults(BIAS);
        run.undo();
        assertEquals(first, run.scenario());
        assertFaults();
        for (int i = 0; i < 3; i++) {
            run.redo();
            run.advance(3);
        }
        assertFaults();
        for (int i = 0; i < 3; i++) {
            run.undo();
            run.advance(3);
        }
        assertEquals(first, run.scenario());
        assertFaults();
    }

    /** Another event makes all events marks of the timeline with the move. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aSwitchWithoutEffectReturnsWithThePlanAfterAMove(boolean anotherEvent) {
        run.advanceTo(7);
        if (anotherEvent) {
            run.send(new Command.InjectFault("left", BIAS));
        }
        run.planWithUndo(at(0.05, OFF), at(0.15, ON));
        run.advanceTo(10);
        run.send(ON);
        run.advanceTo(30);
        List<TimedCommand> timeline = run.timeline();
        run.undo();
        run.seek(5);
        run.redo();
        // A mark of another event comes before those that redo adds.
        assertEquals(Set.copyOf(timeline), Set.copyOf(run.timeline()));
        assertEquals(timeline.size(), run.timeline().size());
        run.advanceTo(30);
        assertSameRun();
        assertEquals(Optional.empty(), callOnEdt(run.edits()::redoName));
        run.undo();
        assertEquals(Optional.of("Switch front on"), callOnEdt(run.edits()::undoName), "it is a mark now");
        run.undo();
        assertEquals(anotherEvent ? 1 : 0, run.timeline().size());
    }

    @Test
    void aSwitchThatHasAnEffectAgainIsKeptWhenAnEarlierTickIsEdited() {
        run.planWithUndo(at(0.05, OFF), at(0.15, ON));
        run.advanceTo(10);
        run.send(ON);
        run.advanceTo(20);
        List<TimedCommand> timeline = run.timeline();
        run.send(new Command.SetPlatform(0.24, 0.19, 0.25));
        run.undo();
        run.undo();
        run.seek(5);
        run.redo();
        run.redo();
        assertEquals(Optional.empty(), callOnEdt(run.edits()::redoName));
        assertEquals(timeline, run.timeline());
        run.advanceTo(30);
        assertTrue(SessionFrames.frame(run.workspace()).snapshot().sensors().stream()
                .allMatch(sensor -> sensor.spec().on()));
        for (int i = 0; i < 3; i++) {
            run.undo();
        }
        assertEquals(List.of(), run.timeline());
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
    }

    @Test
    void aNewEditDropsALaterSwitchWithoutEffect() {
        run.planWithUndo(at(0.05, OFF), at(0.15, ON));
        run.advanceTo(10);
        run.send(ON);
        run.advanceTo(30);
        run.undo();
        run.seek(5);
        assertNothingReturnsWithAnotherPlan(at(0.06, OFF), at(0.2, ON));
    }

    @Test
    void aNewEditDropsALaterSwitchWithoutEffectAndItsUndo() {
        run.planWithUndo(at(0.05, OFF));
        run.advanceTo(10);
        run.send(ON);
        run.advanceTo(20);
        run.undo();
        run.advanceTo(25);
        run.undo();
        run.seek(5);
        assertNothingReturnsWithAnotherPlan(at(0.06, OFF));
    }

    /** Checks that after an edit at the present tick, the timeline has only that edit and another plan. */
    private void assertNothingReturnsWithAnotherPlan(TimedCommand... other) {
        run.send(new Command.SwitchSensor("left", false));
        List<TimedCommand> edited = run.timeline();
        assertEquals(1, edited.size());
        run.planWithUndo(other);
        List<TimedCommand> planned = new ArrayList<>(List.of(other));
        planned.addAll(edited);
        assertEquals(planned, run.timeline());
        run.advanceTo(30);
        assertEquals(planned, run.timeline());
        assertSameRun();
        run.undo();
        assertEquals(edited, run.timeline());
        run.redo();
        run.restart();
        assertEquals(planned, run.timeline());
        run.undo();
        assertEquals(edited, run.timeline());
        run.undo();
        assertEquals(List.of(), run.timeline());
        assertEquals(Optional.empty(), callOnEdt(run.edits()::undoName));
    }
}
