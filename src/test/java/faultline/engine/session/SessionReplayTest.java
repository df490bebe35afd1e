package faultline.engine.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.metrics.RunResult;
import faultline.engine.recording.Recording;
import faultline.geometry.Pose;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Going back in a run by running it again: the same bits at every tick, and what was done later is done again unless
 * something else is.
 */
@Timeout(value = 2, unit = TimeUnit.MINUTES)
class SessionReplayTest {

    private static final Obstacle POLE = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(3, 2, 0));
    private static final SimulationSetup ROOM = SimulationSetup.of(
                    new WorldSpec(4, 3, true, 3, List.of(POLE)), new Pose(0.6, 0.6, 0.3))
            .withTimeline(List.of(new SimulationSetup.TimedCommand(1, new Command.SwitchSensor("rear", false))))
            .withSeed(7)
            .withDuration(60);

    /** What was done to a run of a thousand ticks. */
    private static final Journal JOURNAL = new Journal(
            ROOM,
            List.of(
                    new Journal.Entry(1, new Command.SetPlatform(0.25, 0.2, 0.25)),
                    new Journal.Entry(400, new Command.InjectFault("left", new Fault.Bias(0.05))),
                    new Journal.Entry(400, new Command.MoveObstacle("pole", new Pose(2.5, 1, 0))),
                    new Journal.Entry(700, new Command.ClearFaults("left"))),
            1000);

    private static final ReferenceRun ORIGINAL = ReferenceRun.replay(JOURNAL, tick -> true);

    private static SessionFrame stepTo(Session session, long tick) {
        while (session.frame().snapshot().tick() < tick) {
            long before = session.frame().snapshot().tick();
            session.step();
            while (session.frame().snapshot().tick() == before) {
                LockSupport.parkNanos(10_000);
            }
        }
        return session.frame();
    }

    @Test
    void atEveryTickTheReplayedSessionHasTheBitsOfTheOriginal() {
        for (long tick : new long[] {0, 1, 399, 400, 401, 699, 700, 1000}) {
            try (Session session = Session.replay(JOURNAL, tick, reached -> true)) {
                assertEquals(tick, session.frame().snapshot().tick());
                assertEquals(
                        ORIGINAL.hashTrace().hashAt(tick),
                        session.frame().frame().trajectoryHash(),
                        "at tick " + tick);
                assertFalse(session.status().running());
            }
        }
    }

    @Test
    void steppingOnDoesAgainWhatWasDone() {
        try (Session session = Session.replay(JOURNAL, 398, reached -> true)) {
            assertEquals(
                    ORIGINAL.hashTrace().hashAt(420),
                    stepTo(session, 420).frame().trajectoryHash());
        }
    }

    @Test
    void aNewCommandMakesItAnotherRun() throws Exception {
        try (Session session = Session.replay(JOURNAL, 398, reached -> true)) {
            session.send(new Command.SwitchSensor("front", false));
            stepTo(session, 420);
            assertEquals(
                    List.of(JOURNAL.entries().get(0), new Journal.Entry(399, new Command.SwitchSensor("front", false))),
                    session.fullJournal().get().entries());
            assertEquals(420, session.fullJournal().get().ticks());
        }
    }

    @Test
    void aRefusedCommandLeavesTheReplayAsItIs() throws Exception {
        try (Session session = Session.replay(JOURNAL, 398, reached -> true)) {
            session.send(new Command.RemoveObstacle("ghost"));
            assertEquals(JOURNAL, session.fullJournal().get());
            assertEquals(
                    ORIGINAL.hashTrace().hashAt(420),
                    stepTo(session, 420).frame().trajectoryHash());
        }
    }

    @Test
    void theFullJournalAlsoHoldsWhatIsStillToCome() throws Exception {
        try (Session session = Session.replay(JOURNAL, 398, reached -> true)) {
            assertEquals(
                    new Journal(ROOM, JOURNAL.entries().subList(0, 1), 398),
                    session.journal().get());
            assertEquals(JOURNAL, session.fullJournal().get());
            stepTo(session, 400);
            assertEquals(3, session.journal().get().entries().size());
            assertEquals(JOURNAL, session.fullJournal().get());
        }
    }

    @Test
    void theCommandsForTheNextTickAreExecutedAtOnce() throws Exception {
        try (Session session = Session.replay(JOURNAL, 399, reached -> true)) {
            assertEquals(399, session.frame().snapshot().tick());
            assertEquals(
                    new Journal(ROOM, JOURNAL.entries().subList(0, 3), 399),
                    session.journal().get());
            assertEquals(JOURNAL, session.fullJournal().get());
        }
    }

    @Test
    void steppingBackTwiceLosesNothing() throws Exception {
        try (Session once = Session.replay(JOURNAL, 999, reached -> true);
                Session twice = Session.replay(once.fullJournal().get(), 398, reached -> true)) {
            assertEquals(ORIGINAL.hashTrace().hashAt(398), twice.frame().frame().trajectoryHash());
            assertEquals(JOURNAL, twice.fullJournal().get());
        }
    }

    @Test
    void theReplayIsRecordedToo() {
        try (Session session = Session.replay(JOURNAL, 1000, reached -> true)) {
            Recording recording = session.frame().recording();
            assertEquals(1001, recording.trace().tickCount());
            assertEquals(
                    400,
                    recording
                            .events()
                            .get(recording.events().firstIndexSince(400))
                            .tick());
            assertEquals(
                    500,
                    recording.keyframes().frameAt(500).orElseThrow().snapshot().tick());
        }
    }

    @Test
    void aReferenceRunKnowsWhereTheRobotWas() {
        assertEquals(1000, ORIGINAL.lastTick());
        assertEquals(ROOM.start(), ORIGINAL.pose(0));
        try (Session session = Session.replay(JOURNAL, 600, reached -> true)) {
            assertEquals(session.frame().snapshot().pose(), ORIGINAL.pose(600));
        }
        assertEquals(ORIGINAL.pose(1000), ORIGINAL.pose(5000), "it stays at the end");
        assertTrue(ORIGINAL.path().size() > 100);
    }

    /** The mean of the squares depends on every tick in which the robot follows a wall. */
    @Test
    void aRunHasTheMeasuresThatItHasWithoutAWindow() {
        SimulationSetup setup = ROOM.withDuration(40);
        RunResult expected = HeadlessRun.run(setup, ControllerMode.DIRECT, List.of());
        Journal journal = new Journal(setup, List.of(), 4000);
        RunMeasures reference = ReferenceRun.replay(journal, tick -> true).measures();
        assertEquals(expected.coverage().orElseThrow(), reference.coverage());
        assertEquals(expected.distanceRms().orElseThrow(), reference.distanceRms());
        assertEquals(expected.followRms().orElseThrow(), reference.followRms());
        try (Session session = Session.replay(journal, 4000, reached -> true)) {
            assertEquals(reference, session.frame().measures());
            assertEquals(expected.coverage(), session.frame().coverage());
            assertEquals(expected.distanceRms(), session.frame().distanceRms());
        }
    }

    /** The front sensor is 0.125 m before the middle; the near side of the pole is at 0.9 m. */
    @Test
    void theFirstFrameShowsReadingsAfterTheCommandsForTheNextTick() {
        SimulationSetup setup = ROOM.withStart(new Pose(0.5, 2, 0));
        Command move = new Command.MoveObstacle("pole", new Pose(1, 2, 0));
        Journal journal = new Journal(setup, List.of(new Journal.Entry(1, move)), 5);
        try (Session session = Session.replay(journal, 0, reached -> true)) {
            assertEquals(
                    0.9 - 0.625,
                    session.frame().snapshot().sensors().get(0).truth().encoded(),
                    1e-12);
        }
    }

    @Test
    void aSimulationWithAnotherSetupExecutesTheCommandsOfTimelineAndJournalForTheNextTick() throws Exception {
        TimedCommand timed = new TimedCommand(4, new Command.SwitchSensor("left", false));
        Journal.Entry later = new Journal.Entry(401, new Command.SwitchSensor("right", false));
        Journal journal = new Journal(ROOM.withTimeline(List.of(timed)), List.of(later), 1000);
        try (Session session = Session.resimulate(journal, 399, reached -> true)) {
            assertSame(journal.setup(), session.setup());
            assertEquals(List.of("left"), sensorsThatAreOff(session));
        }
        try (Session session = Session.resimulate(journal, 400, reached -> true)) {
            assertEquals(List.of("left", "right"), sensorsThatAreOff(session));
            assertEquals(journal, session.fullJournal().get());
        }
    }

    private static List<String> sensorsThatAreOff(Session session) {
        return session.frame().snapshot().robot().sensors().stream()
                .filter(sensor -> !sensor.on())
                .map(SensorSpec::id)
                .toList();
    }

    @Test
    void twoRunsDivergeAtTheFirstTickThatDiffersByABit() {
        // A bias on a sensor that looks at the followed wall shows in its reading in the very tick of the command.
        Journal without = new Journal(ROOM, JOURNAL.entries().subList(0, 1), 1000);
        assertEquals(
                OptionalLong.of(400),
                ORIGINAL.hashTrace()
                        .firstDifference(
                                ReferenceRun.replay(without, tick -> true).hashTrace(), 0));
        assertEquals(
                OptionalLong.empty(),
                ORIGINAL.hashTrace()
                        .firstDifference(
                                ReferenceRun.replay(JOURNAL, tick -> true).hashTrace(), 0));
        assertEquals(
                OptionalLong.empty(),
                ORIGINAL.hashTrace()
                        .firstDifference(
                                ReferenceRun.replay(
                                                new Journal(
                                                        ROOM, JOURNAL.entries().subList(0, 1), 399),
                                                tick -> true)
                                        .hashTrace(),
                                0));
        assertNotEquals(
                ORIGINAL.hashTrace().hashAt(400),
                ReferenceRun.replay(without, tick -> true).hashTrace().hashAt(400));
    }

    /** Stands still. */
    private record Idle(AtomicInteger closed) implements Controller, AutoCloseable {
        @Override
        public Decision decide(Observation observation) {
            return new Decision(0, 0, Telemetry.ofState(ControllerState.of("IDLE")));
        }

        @Override
        public void close() {
            closed.incrementAndGet();
        }
    }

    @Test
    void aReplayThatFailsClosesItsController() {
        AtomicInteger closed = new AtomicInteger();
        ControllerSource source = new ControllerSource() {
            @Override
            public Controller start(RunConditions run) {
                return new Idle(closed);
            }

            @Override
            public boolean limitsAnswerTime() {
                return false;
            }
        };
        Journal journal =
                new Journal(ROOM.withController(new ControllerSpec.Chosen(ROOM.controller(), source)), List.of(), 10);
        assertThrows(
                OutOfMemoryError.class,
                () -> Session.replay(journal, 10, tick -> {
                    throw new OutOfMemoryError("in a test");
                }));
        assertEquals(1, closed.get());
    }

    @Test
    void aReferenceRunCanBeCancelled() {
        List<Long> asked = new ArrayList<>();
        assertThrows(
                CancellationException.class,
                () -> ReferenceRun.replay(JOURNAL, tick -> {
                    asked.add(tick);
                    return tick < 3;
                }));
        assertEquals(List.of(0L, 1L, 2L, 3L), asked);
    }
}
