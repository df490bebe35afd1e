package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.session.Session;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.scenario.Scenario;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Edits of a sensor that is switched meanwhile leave its switch alone, as the scenario does. */
@ExtendWith(EdtChecker.class)
class TimedSwitchTest {

    private static final Command OFF = new Command.SwitchSensor("front", false);

    private final EditedRun run = new EditedRun();

    @AfterEach
    void close() {
        run.close();
    }

    private SensorSpec front() {
        return SessionFrames.frame(run.workspace())
                .snapshot()
                .robot()
                .sensor("front")
                .orElseThrow();
    }

    private void assertSwitchedAsByTheScenario(boolean on) {
        run.advance(2);
        assertEquals(on, front().on(), run.timeline().toString());
        Journal journal = new Journal(run.scenario().setup(), List.of(), 0);
        try (Session replayed = Session.replay(journal, run.tick(), tick -> true)) {
            assertEquals(
                    on,
                    replayed.frame()
                            .snapshot()
                            .robot()
                            .sensor("front")
                            .orElseThrow()
                            .on());
        }
    }

    private void sendLongerRange() {
        SensorSpec front = front();
        run.send(new Command.ConfigureSensor(front.withRange(front.range() * 1.1)));
    }

    @Test
    void anUndoLeavesASensorOffThatTheTimelineHasSwitchedOff() {
        run.plan(List.of(new TimedCommand(0.2, OFF)));
        double range = front().range();
        run.advanceTo(10);
        sendLongerRange();
        run.advanceTo(30);
        run.undo();
        assertEquals(range, front().range());
        assertSwitchedAsByTheScenario(false);
    }

    @Test
    void aRedoLeavesASensorOffThatTheTimelineHasSwitchedOff() {
        run.plan(List.of(new TimedCommand(0.2, OFF)));
        run.advanceTo(10);
        sendLongerRange();
        run.undo();
        run.advanceTo(30);
        run.redo();
        assertSwitchedAsByTheScenario(false);
    }

    @Test
    void anUndoAndARedoFollowASwitchByTheUser() {
        run.advanceTo(10);
        sendLongerRange();
        run.advanceTo(15);
        run.send(OFF);
        run.advanceTo(30);
        run.undo();
        assertSwitchedAsByTheScenario(true);
        run.undo();
        assertSwitchedAsByTheScenario(true);
        run.redo();
        run.redo();
        assertSwitchedAsByTheScenario(false);
    }

    /** The command for the range was executed while the sensor was off. */
    @Test
    void anEditOfASensorThatIsOffLeavesItOnWhenTheTimelineNoLongerSwitchesIt() {
        run.plan(List.of(new TimedCommand(0.2, OFF)));
        run.advanceTo(30);
        sendLongerRange();
        run.plan(List.of());
        assertSwitchedAsByTheScenario(true);
        run.undo();
        assertSwitchedAsByTheScenario(true);
    }

    @Test
    void aDragThatIsCancelledAfterATimedSwitchIsNoEdit() {
        run.plan(List.of(new TimedCommand(0.2, OFF)));
        run.advanceTo(10);
        SensorSpec start = front();
        runOnEdt(run.sender()::beginGesture);
        run.drag(new Command.ConfigureSensor(start.withRange(2)));
        run.advanceTo(30);
        run.drag(new Command.ConfigureSensor(start.withRange(2.5)));
        run.drag(new Command.ConfigureSensor(start));
        runOnEdt(run.sender()::endGesture);
        assertFalse(callOnEdt(run.edits()::canUndo));
        assertSwitchedAsByTheScenario(false);
    }

    /** The undo is another command than the reverse of the edit, because the sensor is off now. */
    @Test
    void anUndoAfterATimedSwitchRestoresTheScenarioExactly() {
        SensorSpec tuned = front().withNoise(0.1);
        run.plan(List.of(new TimedCommand(0.05, new Command.ConfigureSensor(tuned)), new TimedCommand(0.2, OFF)));
        Scenario before = run.scenario();
        run.advanceTo(10);
        sendLongerRange();
        run.advanceTo(30);
        run.undo();
        assertEquals(before, run.scenario());
    }

    @Test
    void theJournalOfARunWithEditsAroundASwitchReplaysToTheBit() {
        run.plan(List.of(new TimedCommand(0.2, OFF)));
        run.advanceTo(10);
        sendLongerRange();
        run.advanceTo(30);
        run.undo();
        run.advance(2);
        run.redo();
        run.advance(2);
        Scenario replay =
                callOnEdt(run.workspace()::replayScenario).orElseThrow().join();
        assertEquals(
                SessionFrames.trajectoryHash(run.workspace()),
                HeadlessRun.run(replay.setup(), ControllerMode.DIRECT, List.of())
                        .trajectoryHash());
    }
}
