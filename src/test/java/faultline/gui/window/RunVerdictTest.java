package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Journal;
import faultline.engine.RunProblem;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.engine.recording.Recording;
import faultline.engine.session.SampleSessionFrames;
import faultline.engine.session.Session;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.external.ControllerProblem;
import faultline.geometry.Vector2;
import faultline.io.Message;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioRun;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.world.Collision;
import faultline.world.Command;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Tests the verdicts of the window on runs of scenarios. */
class RunVerdictTest {

    private static final SessionStatus PAUSED = new SessionStatus(false, 1, 0, 0, null, null);
    private static final SessionStatus RUNNING = new SessionStatus(true, 1, 1, 0, null, null);

    private static SessionFrame frameAt(SimulationSetup setup, long tick) {
        try (Session session = Session.replay(new Journal(setup, List.of(), tick), tick, reached -> true)) {
            return session.frame();
        }
    }

    private static Scenario with(Scenario scenario, double duration, Expectation expectation) {
        return new Scenario(
                scenario.name(), scenario.description(), false, scenario.setup().withDuration(duration), expectation);
    }

    private static Expectation coverage(double least) {
        return new Expectation(List.of(new Expectation.Collides(false), new Expectation.MinCoverage(least)));
    }

    @Test
    void aRunThatGoesOnHasNoVerdict() throws ScenarioException {
        Scenario office = with(Scenario.loadShipped("office.xml"), 3, coverage(0.5));
        assertEquals(Optional.empty(), RunVerdict.of(frameAt(office.setup(), 200), PAUSED, office));
        assertEquals(
                Optional.empty(),
                RunVerdict.of(frameAt(office.setup(), 300), RUNNING, office),
                "at the end, but still running");
    }

    /** A traceback on one line could not be read, and the event log has its lines. */
    @Test
    void ofWhatAFailedControllerHasPrintedOnlyTheLastLineIsShown() throws ScenarioException {
        Scenario office = Scenario.loadShipped("office.xml");
        Message ended = ControllerProblem.ENDED.with(ControllerProblem.CONTROLLER.with("me.py"), "", 1, "");
        Message reason = ControllerProblem.LAST_LINES.with(ended, "KeyError: 'left'", "Traceback: | File \"me.py\"");
        SessionStatus failed = new SessionStatus(false, 1, 0, 0, null, reason);
        RunVerdict verdict =
                RunVerdict.of(frameAt(office.setup(), 10), failed, office).orElseThrow();
        assertEquals(
                "The controller \"me.py\" ended with exit code 1; its last line on standard error: KeyError: 'left'\n"
                        + "The Events tab lists the lines before it.",
                verdict.detail());
    }

    /** The window and the command line give the same verdict. */
    @Test
    void whatDoesNotHoldIsNamedAsTheCommandLineNamesIt() throws ScenarioException {
        for (double least : new double[] {0.05, 0.999}) {
            Scenario office = with(Scenario.loadShipped("office.xml"), 31, coverage(least));
            ScenarioRun run = office.run();
            RunVerdict verdict =
                    RunVerdict.of(frameAt(office.setup(), 3100), PAUSED, office).orElseThrow();
            assertEquals(run.unmetExpectations().isEmpty(), verdict.success(), verdict.title());
            assertEquals(-1, verdict.event());
            if (!verdict.success()) {
                assertEquals("End of the run at 31.000 s: 1 of 2 expectations failed", verdict.title());
                assertTrue(verdict.detail().startsWith("Coverage at least 99.9 % ("), verdict.detail());
            }
        }
    }

    @Test
    void aCollisionNamesItsObstacleAndTheFaults() throws ScenarioException {
        Scenario crash = Scenario.loadShipped("collision-on-purpose.xml");
        RunVerdict verdict =
                RunVerdict.of(frameAt(crash.setup(), 1000), RUNNING, crash).orElseThrow();
        assertEquals("Collision with pole at 9.562 s (x 3.980 m, y 2.050 m)", verdict.title());
        assertEquals("As expected. Active faults: front off, no reading", verdict.detail());
        assertTrue(verdict.success());
        assertEquals(957 - 200, verdict.tickBefore(0.01));
        Scenario unexpected = with(crash, 30, Expectation.NONE);
        verdict =
                RunVerdict.of(frameAt(crash.setup(), 1000), RUNNING, unexpected).orElseThrow();
        assertFalse(verdict.success());
    }

    /** The time passes, and nothing else changes: a robot that has collided stands still. */
    @Test
    void theEndOfTheRunIsNoSuccessAfterACollisionThatIsNotExpected() throws ScenarioException {
        Scenario file = Scenario.loadShipped("collision-on-purpose.xml");
        Expectation state = new Expectation(List.of(new Expectation.MinCoverage(0)));
        Expectation collision = new Expectation(List.of(new Expectation.Collides(true)));
        for (Expectation expectation : List.of(Expectation.NONE, state, collision)) {
            Scenario crash = with(file, 10, expectation);
            RunVerdict after =
                    RunVerdict.of(frameAt(crash.setup(), 999), PAUSED, crash).orElseThrow();
            RunVerdict end =
                    RunVerdict.of(frameAt(crash.setup(), 1000), PAUSED, crash).orElseThrow();
            assertEquals(expectation.equals(collision), after.success(), after.toString());
            assertEquals(after.success(), end.success(), end.toString());
            assertEquals(after.event(), end.event());
        }
    }

    @Test
    void aFailureIsQuotedAsASentence() throws ScenarioException {
        Scenario office = Scenario.loadShipped("office.xml");
        SessionStatus failed =
                new SessionStatus(false, 1, 0, 0, null, RunProblem.OTHER.with("tick 7: the controller threw"));
        SessionFrame frame =
                SampleSessionFrames.unmeasured(frameAt(office.setup(), 7).frame(), Recording.EMPTY);
        RunVerdict verdict = RunVerdict.of(frame, failed, office).orElseThrow();
        assertEquals("Tick 7: the controller threw", verdict.detail());
        assertEquals(0, verdict.tickBefore(0.01));
    }

    @Test
    void aFaultMadeByHandIsNamedToo() throws ScenarioException {
        Scenario crash = Scenario.loadShipped("collision-on-purpose.xml");
        Journal journal = new Journal(
                crash.setup(), List.of(new Journal.Entry(50, new Command.SwitchSensor("left", false))), 1000);
        try (Session session = Session.replay(journal, 1000, reached -> true)) {
            RunVerdict verdict = RunVerdict.of(session.frame(), RUNNING, crash).orElseThrow();
            assertTrue(verdict.detail().endsWith("front off, no reading; left switched off"), verdict.detail());
        }
    }

    /** The banner covers the canvas, so its text is short even if all sensors have failed. */
    @Test
    void equalFaultsOfManySensorsAreOneEntryAndOnlyTheFirstOfManyDifferentOnesAreListed() {
        Map<String, List<Fault>> equal = new TreeMap<>();
        Map<String, List<Fault>> different = new TreeMap<>();
        for (int i = 10; i < 40; i++) {
            equal.put("s" + i, List.of(FaultKind.STUCK.createFault(0.4)));
            different.put("s" + i, List.of(FaultKind.STUCK.createFault(i / 100.0)));
        }
        assertEquals(
                "Active faults: 30 sensors: stuck 0.40 m; left switched off; right switched off",
                RunVerdict.faultText(collision(equal, List.of("left", "right"))));
        assertEquals(
                "Active faults: s10 stuck 0.10 m; s11 stuck 0.11 m; s12 stuck 0.12 m; s13 stuck 0.13 m; "
                        + "s14 stuck 0.14 m; s15 stuck 0.15 m; s16 stuck 0.16 m; s17 stuck 0.17 m and 22 more",
                RunVerdict.faultText(collision(different, List.of())));
    }

    @Test
    void theFaultsOfMotorsAreNamedAfterThoseOfSensors() {
        MotorFaults motors = new MotorFaults(List.of(), List.of(new MotorFault.Weak(0.7), new MotorFault.NoDrive()));
        Collision collision = new Collision(Vector2.ZERO, 1, 100, "pole", Map.of(), List.of("left"), motors);
        assertEquals(
                "Active faults: left switched off; right motors weak 0.70; right motors dead",
                RunVerdict.faultText(collision));
    }

    private static Collision collision(Map<String, List<Fault>> faults, List<String> off) {
        return new Collision(Vector2.ZERO, 1, 100, "pole", faults, off, MotorFaults.NONE);
    }
}
