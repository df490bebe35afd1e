package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.record.Channels;
import faultline.engine.record.EventLog;
import faultline.engine.record.RunEvent;
import faultline.engine.record.StateTally;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What a session remembers of its run, compared with what a direct run of the same setup shows tick by tick. */
@Timeout(value = 2, unit = TimeUnit.MINUTES)
class RecorderTest {

    private static final int TICKS = 6000;
    private static final Command OFF = new Command.SwitchSensor("rear", false);
    private static final Command UNKNOWN = new Command.SwitchSensor("nose", false);

    private final Setup room = setup(List.of(new Setup.Timed(0, OFF), new Setup.Timed(1.5, new Command.InjectFault("left", new Fault.Bias(0.02))),
            new Setup.Timed(2, UNKNOWN)));

    private static Setup setup(List<Setup.Timed> timeline) {
        Obstacle desk = new Obstacle("desk", new ObstacleShape.Rectangle(0.6, 0.4), new Pose(2, 1.5, 0.4));
        return new Setup(new WorldSpec(4, 3, true, 3, List.of(desk)), RobotSpec.DEFAULT, new Pose(0.6, 0.6, 0.3),
                ControllerSpec.WallFollowing.DEFAULT,
                timeline, 0.01, 1, 60);
    }

    /** A moment of the direct run. */
    private record Moment(long tick, String state, int transitions, double measured, double leftVolts, double truth, double reported, long hash) {
    }

    private static List<Moment> moments(Setup setup, int ticks) {
        List<Moment> moments = new ArrayList<>();
        HeadlessRun.run(setup.withDuration(ticks * setup.dt()), ControllerMode.DIRECT,
                List.of(s -> moments.add(new Moment(s.ticks(), s.telemetry().state(),
                s.telemetry().transitions(), s.telemetry().measured(), s.leftVolts(), s.trueReading(2), s.reportedReading(2), s.trajectoryHash()))));
        return moments;
    }

    /** The frame of a session that has run to a tick or a little farther, as fast as it can, while nobody looked. */
    private static Frame ran(Session session, long ticks) {
        session.setSpeed(Double.POSITIVE_INFINITY);
        session.run();
        while (session.frame().world().tick() < ticks) {
            LockSupport.parkNanos(20_000_000);
        }
        session.pause();
        while (session.status().running()) {
            LockSupport.parkNanos(100_000);
        }
        return session.frame();
    }

    private static List<RunEvent> events(Frame frame) {
        EventLog log = frame.recording().events();
        List<RunEvent> events = new ArrayList<>();
        for (long i = log.first(); i < log.end(); i++) {
            events.add(log.get(i));
        }
        return events;
    }

    @Test
    void atFullSpeedNoTransitionIsMissed() {
        try (Session session = Session.start(room)) {
            Frame frame = ran(session, TICKS);
            List<RunEvent.Transition> seen = events(frame).stream().filter(RunEvent.Transition.class::isInstance)
                    .map(RunEvent.Transition.class::cast).filter(transition -> transition.tick() <= TICKS).toList();
            List<Moment> moments = moments(room, TICKS);
            assertTrue(seen.size() >= 8, "too few to judge by: " + seen.size());
            assertEquals(moments.get(TICKS).transitions(), seen.size());
            for (RunEvent.Transition transition : seen) {
                Moment at = moments.get((int) transition.tick());
                assertEquals(at.state(), transition.to());
                assertEquals(moments.get((int) transition.tick() - 1).state(), transition.from());
                assertEquals(transition.tick() * 0.01, transition.time(), 1e-9);
            }
        }
    }

    @Test
    void everyTickIsTraced() {
        try (Session session = Session.start(room)) {
            var level = ran(session, TICKS).recording().trace().finest();
            for (Moment moment : moments(room, TICKS)) {
                assertEquals((float) moment.measured(), level.low(Channels.MEASURED, moment.tick()));
                assertEquals((float) moment.leftVolts(), level.low(Channels.LEFT_VOLTS, moment.tick()));
                assertEquals((float) moment.truth(), level.low(Channels.truth(2), moment.tick()));
                assertEquals((float) moment.reported(), level.low(Channels.reported(2), moment.tick()));
            }
        }
    }

    @Test
    void theTimelineIsLoggedWithItsRefusals() {
        try (Session session = Session.start(room)) {
            List<RunEvent> commands = events(ran(session, 300)).stream().filter(event -> !(event instanceof RunEvent.Transition)).toList();
            assertEquals(List.of(new RunEvent.Done(0, 0, OFF),
                    new RunEvent.Done(150, 1.5, new Command.InjectFault("left", new Fault.Bias(0.02))),
                    new RunEvent.Refused(200, 2, UNKNOWN, "the robot has no sensor nose")), commands);
        }
    }

    @Test
    void whatIsDoneWhilePausedIsLoggedAtOnceWithTheComingTick() {
        try (Session session = Session.start(setup(List.of()))) {
            session.send(OFF);
            session.send(UNKNOWN);
            while (session.frame().recording().events().end() < 2) {
                LockSupport.parkNanos(100_000);
            }
            assertEquals(List.of(new RunEvent.Done(1, 0.01, OFF), new RunEvent.Refused(1, 0.01, UNKNOWN, "the robot has no sensor nose")),
                    events(session.frame()));
        }
    }

    @Test
    void theCollisionIsLoggedOnce() {
        Setup blind = new Setup(room.world(), room.robot(), new Pose(0.6, 0.6, 0), new ControllerSpec.Drive(3, 3), List.of(), 0.01, 1, 60);
        try (Session session = Session.start(blind)) {
            Frame frame = ran(session, 2000);
            List<RunEvent> events = events(frame);
            assertEquals(1, events.size());
            assertEquals(frame.world().collision(), Optional.of(((RunEvent.Collided) events.get(0)).collision()));
        }
    }

    @Test
    void timeInStatesAndWaysBetweenThemAddUp() {
        try (Session session = Session.start(room)) {
            Frame frame = ran(session, TICKS);
            StateTally tally = frame.recording().states();
            assertEquals(frame.world().tick(), tally.states().stream().mapToLong(StateTally.Stay::ticks).sum());
            assertEquals(frame.control().transitions(), tally.ways().stream().mapToLong(StateTally.Way::count).sum());
            List<Moment> moments = moments(room, (int) frame.world().tick());
            long inFollow = moments.stream().filter(moment -> moment.tick() > 0 && moment.state().equals("FOLLOW")).count();
            assertEquals(inFollow, tally.stay("FOLLOW").orElseThrow().ticks());
            assertEquals(1, tally.count("SEARCH", "TURN"));
            assertEquals(0, tally.count("FOLLOW", "ALIGN"));
        }
    }

    @Test
    void keyframesAreEvenlySpacedTrueMomentsAndNeverTooMany() {
        try (Session session = Session.start(room)) {
            Frame frame = ran(session, TICKS);
            Keyframes keyframes = frame.recording().keyframes();
            List<Moment> moments = moments(room, (int) frame.world().tick());
            assertTrue(keyframes.size() <= KeyframeRecorder.MOST && keyframes.size() >= KeyframeRecorder.MOST / 2);
            for (long tick = 0; tick < frame.world().tick(); tick += 100) {
                Frame key = keyframes.at(tick).orElseThrow();
                assertEquals(tick / keyframes.stride() * keyframes.stride(), key.world().tick());
                assertEquals(moments.get((int) key.world().tick()).hash(), key.trajectoryHash());
                assertSame(Recording.EMPTY, key.recording());
            }
        }
    }

    @Test
    void anEarlierViewOfTheKeyframesOutlivesTheirThinning() {
        KeyframeRecorder recorder = new KeyframeRecorder();
        try (Simulation simulation = new Simulation(room, ControllerMode.DIRECT)) {
            recorder.add(simulation.frame());
            while (simulation.ticks() < 1023) {
                simulation.tick();
                recorder.add(simulation.frame());
            }
            Keyframes early = recorder.view();
            simulation.tick();
            recorder.add(simulation.frame());
            assertEquals(1023, early.at(1023).orElseThrow().world().tick());
            assertEquals(2, recorder.view().stride());
            assertEquals(1022, recorder.view().at(1023).orElseThrow().world().tick());
            assertEquals(1024, recorder.view().at(1025).orElseThrow().world().tick());
            assertNotEquals(early.size(), recorder.view().size());
        }
    }
}
