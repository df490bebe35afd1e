package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.HeadlessRun;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.Workspace;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.sensor.Fault;
import faultline.sensor.SignalFault;
import faultline.world.Command;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Events that are undone after the timeline has changed what they are about. */
@ExtendWith(EdtChecker.class)
class LaterUndoTest {

    private static final Fault DRIFT = new SignalFault.Drift(0.01);
    private static final Fault BIAS = new Fault.Bias(0.1);
    private static final Fault STUCK = new Fault.Stuck(0.4);
    private static final MotorFault WEAK = new MotorFault.Weak(0.9);
    private static final MotorFault WEAKER = new MotorFault.Weak(0.8);

    private Workspace workspace;
    private RunController run;
    private UndoController edits;

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
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
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
        runOnEdt(() -> run.change(now -> now.withSetup(now.setup().withTimeline(timeline))));
        rest();
    }

    private void advanceTo(long end) {
        for (long tick = SessionFrames.tick(workspace); tick < end; tick++) {
            runOnEdt(run::step);
            SessionFrames.awaitTick(workspace, tick + 1);
        }
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

    private void rest() {
        Await.until(
                "the end of the edit",
                () -> !workspace.awaitsCommands() && workspace.task().isEmpty());
    }

    /** Checks the faults of the front sensor in the next tick, and that the edited scenario leads to the same run. */
    private void assertFaults(Fault... expected) {
        advanceTo(SessionFrames.tick(workspace) + 1);
        assertEquals(
                List.of(expected),
                SessionFrames.frame(workspace).snapshot().sensors().stream()
                        .filter(sensor -> sensor.spec().id().equals("front"))
                        .findFirst()
                        .orElseThrow()
                        .faults());
        assertSameRun();
    }

    private void assertMotorFaults(MotorFault... expected) {
        advanceTo(SessionFrames.tick(workspace) + 1);
        assertEquals(
                List.of(expected),
                SessionFrames.frame(workspace).snapshot().motorFaults().left());
        assertSameRun();
    }

    private void assertSameRun() {
        Scenario edited = callOnEdt(() -> workspace.scenario().orElseThrow());
        long ticks = SessionFrames.tick(workspace);
        SimulationSetup setup = edited.setup().withDuration(edited.setup().timeOf(ticks));
        assertEquals(
                HeadlessRun.run(setup, ControllerMode.DIRECT, List.of()).trajectoryHash(),
                SessionFrames.trajectoryHash(workspace));
    }

    @Test
    void aFaultThatHasEndedDoesNotReturn() {
        plan();
        advanceTo(29);
        send(new Command.InjectFault("front", STUCK));
        advanceTo(52);
        undo();
        assertFaults();
        runOnEdt(edits::redo);
        rest();
        assertFaults(STUCK);
        undo();
        assertFaults();
    }

    @Test
    void aFaultThatHasBegunContinues() {
        plan(at(0.45, new Command.InjectFault("front", BIAS)));
        advanceTo(29);
        send(new Command.InjectFault("front", STUCK));
        advanceTo(52);
        undo();
        assertFaults(BIAS);
    }

    @Test
    void aRepairedFaultReturnsOnlyUntilItsEnd() {
        plan();
        advanceTo(29);
        send(new Command.ClearFault("front", DRIFT));
        advanceTo(34);
        undo();
        assertFaults(DRIFT);
        advanceTo(41);
        assertFaults();
    }

    @Test
    void aRepairIsUndoneWithoutEffectAfterTheEndOfTheFault() {
        plan(at(0.45, new Command.InjectFault("front", BIAS)));
        advanceTo(29);
        send(new Command.ClearFaults("front"));
        advanceTo(52);
        undo();
        assertFaults(BIAS);
        assertEquals("Repair front", callOnEdt(() -> edits.redoName().orElseThrow()));
    }

    @Test
    void faultsOfMotorsAreUndoneInTheSameWay() {
        plan();
        advanceTo(29);
        send(new Command.InjectMotorFault(MotorSide.LEFT, WEAKER));
        advanceTo(52);
        undo();
        assertMotorFaults();
    }

    @Test
    void aSwitchIsUndoneWithoutEffectAfterALaterOne() {
        plan(at(0.45, new Command.SwitchSensor("front", false)));
        advanceTo(29);
        send(new Command.SwitchSensor("front", false));
        advanceTo(52);
        undo();
        assertSameRun();
        assertEquals(
                false,
                SessionFrames.frame(workspace)
                        .snapshot()
                        .sensors()
                        .get(0)
                        .spec()
                        .on());
    }

    /** What was undone is removed from the timeline, too. */
    @Test
    void anUndoneFaultIsNotOnTheTimelineAfterAMoveBack() {
        plan();
        advanceTo(29);
        send(new Command.InjectFault("front", STUCK));
        advanceTo(52);
        undo();
        runOnEdt(edits::redo);
        rest();
        advanceTo(55);
        runOnEdt(() -> run.navigator().seek(10));
        rest();
        undo();
        assertEquals(
                4,
                callOnEdt(() -> workspace.scenario().orElseThrow())
                        .setup()
                        .timeline()
                        .size());
        advanceTo(60);
        assertFaults();
    }
}
