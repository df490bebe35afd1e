package faultline.engine.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.Frame;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.session.Session;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Refusal;
import faultline.world.WorldSpec;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongFunction;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What a session remembers of its run, compared with what a direct run of the same setup shows tick by tick. */
@Timeout(value = 2, unit = TimeUnit.MINUTES)
class RecorderTest {

    private static final int TICKS = 6000;
    private static final Command OFF = new Command.SwitchSensor("rear", false);
    private static final Command UNKNOWN = new Command.SwitchSensor("nose", false);

    private final SimulationSetup room = setup(List.of(
            new SimulationSetup.TimedCommand(0, OFF),
            new SimulationSetup.TimedCommand(1.5, new Command.InjectFault("left", new Fault.Bias(0.02))),
            new SimulationSetup.TimedCommand(2, UNKNOWN)));

    private static SimulationSetup setup(List<SimulationSetup.TimedCommand> timeline) {
        Obstacle desk = new Obstacle("desk", new ObstacleShape.RectangleShape(0.6, 0.4), new Pose(2, 1.5, 0.4));
        return SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of(desk)), new Pose(0.6, 0.6, 0.3))
                .withTimeline(timeline)
                .withDuration(60);
    }

    /** A moment of the direct run. */
    private record Moment(
            long tick,
            ControllerState state,
            int transitions,
            double measuredDistance,
            double leftVolts,
            double rightVolts,
            double heading,
            Velocity velocity,
            double trueReading,
            double reportedReading,
            long hash) {}

    private static List<Moment> moments(SimulationSetup setup, int ticks) {
        List<Moment> moments = new ArrayList<>();
        HeadlessRun.run(
                setup.withDuration(ticks * setup.dt()),
                ControllerMode.DIRECT,
                List.of(s -> moments.add(new Moment(
                        s.ticks(),
                        s.telemetry().state(),
                        s.telemetry().transitions(),
                        s.telemetry().wall().measuredDistance(),
                        s.leftVolts(),
                        s.rightVolts(),
                        s.pose().heading(),
                        s.velocity(),
                        s.trueReading(2),
                        s.reportedReading(2),
                        s.trajectoryHash()))));
        return moments;
    }

    /**
     * Returns the frame of a session that has run at full speed to a tick or a little farther without frame requests.
     */
    private static SessionFrame runTo(Session session, long ticks) {
        session.setSpeed(Double.POSITIVE_INFINITY);
        session.resume();
        while (session.frame().snapshot().tick() < ticks) {
            LockSupport.parkNanos(20_000_000);
        }
        session.pause();
        while (session.status().running()) {
            LockSupport.parkNanos(100_000);
        }
        return session.frame();
    }

    private static List<RunEvent> events(SessionFrame frame) {
        EventLog log = frame.recording().events();
        List<RunEvent> events = new ArrayList<>();
        for (long i = log.firstIndex(); i < log.endIndex(); i++) {
            events.add(log.get(i));
        }
        return events;
    }

    @Test
    void atFullSpeedNoTransitionIsMissed() {
        try (Session session = Session.start(room)) {
            SessionFrame frame = runTo(session, TICKS);
            List<RunEvent.StateChanged> seen = events(frame).stream()
                    .filter(RunEvent.StateChanged.class::isInstance)
                    .map(RunEvent.StateChanged.class::cast)
                    .filter(transition -> transition.tick() <= TICKS)
                    .toList();
            List<Moment> moments = moments(room, TICKS);
            assertTrue(seen.size() >= 8, "too few for this test: " + seen.size());
            assertEquals(moments.get(TICKS).transitions(), seen.size());
            for (RunEvent.StateChanged transition : seen) {
                Moment at = moments.get((int) transition.tick());
                assertEquals(at.state(), transition.to());
                assertEquals(moments.get((int) transition.tick() - 1).state(), transition.from());
                assertEquals(transition.tick() * 0.01, transition.time(), 1e-9);
            }
        }
    }

    @Test
    void timesAreMultiplesOfTheTickWithoutRoundingErrors() {
        try (Session session = Session.start(room)) {
            List<RunEvent> seen = events(runTo(session, TICKS)).stream()
                    .filter(event -> !(event instanceof RunEvent.Collided))
                    .toList();
            assertTrue(seen.size() > 10, "events: " + seen.size());
            for (RunEvent event : seen) {
                BigDecimal exact = new BigDecimal("0.01").multiply(BigDecimal.valueOf(event.tick()));
                assertEquals(exact.doubleValue(), event.time(), event::toString);
            }
        }
    }

    @Test
    void withMotorsTooSlowForTheTurnRateF4IsStillJustBeforeAlign() {
        RobotSpec slow = room.robot().withMotor(new MotorSpec(0.05, 0.1, 3.2)).withTurnRate(StrictMath.toRadians(400));
        assertTrue(
                2 * slow.motor().maxSpeed() / slow.track() < slow.turnRate() / 1.5, "the motors limit the turn rate");
        try (Session session = Session.start(room.withRobot(slow))) {
            RunEvent.AlignmentTimed timed = events(runTo(session, 1000)).stream()
                    .filter(RunEvent.AlignmentTimed.class::isInstance)
                    .map(RunEvent.AlignmentTimed.class::cast)
                    .findFirst()
                    .orElseThrow();
            assertEquals(timed.time(), timed.f4(), 3 * room.dt());
        }
    }

    @Test
    void everyTickIsTraced() {
        try (Session session = Session.start(room)) {
            var level = runTo(session, TICKS).recording().trace().finestLevel();
            for (Moment moment : moments(room, TICKS)) {
                assertEquals(
                        (float) moment.measuredDistance(), level.min(TraceChannels.MEASURED_DISTANCE, moment.tick()));
                assertEquals((float) moment.leftVolts(), level.min(TraceChannels.LEFT_VOLTS, moment.tick()));
                double heading = (double) level.min(TraceChannels.HEADING, moment.tick())
                        + level.min(TraceChannels.HEADING_REST, moment.tick());
                assertEquals(moment.heading(), heading, 1e-12);
                assertEquals((float) moment.velocity().linear(), level.min(TraceChannels.VELOCITY, moment.tick()));
                assertEquals((float) moment.velocity().angular(), level.max(TraceChannels.TURN_RATE, moment.tick()));
                // 0.1 m/s for each volt, at most 6 V, and 0.18 m between the wheels.
                double left = 0.1 * Math.max(-6, Math.min(6, moment.leftVolts()));
                double right = 0.1 * Math.max(-6, Math.min(6, moment.rightVolts()));
                assertEquals((left + right) / 2, level.min(TraceChannels.COMMANDED_VELOCITY, moment.tick()), 1e-6);
                assertEquals((right - left) / 0.18, level.min(TraceChannels.COMMANDED_TURN_RATE, moment.tick()), 1e-5);
                assertEquals((float) moment.trueReading(), level.min(TraceChannels.trueReading(2), moment.tick()));
                assertEquals(
                        (float) moment.reportedReading(), level.min(TraceChannels.reportedReading(2), moment.tick()));
            }
        }
    }

    @Test
    void theTimelineIsLoggedWithItsRefusals() {
        try (Session session = Session.start(room)) {
            List<RunEvent> commands = events(runTo(session, 300)).stream()
                    .filter(event ->
                            event instanceof RunEvent.CommandExecuted || event instanceof RunEvent.CommandRefused)
                    .toList();
            assertEquals(
                    List.of(
                            new RunEvent.CommandExecuted(0, 0, OFF),
                            new RunEvent.CommandExecuted(
                                    150, 1.5, new Command.InjectFault("left", new Fault.Bias(0.02))),
                            new RunEvent.CommandRefused(
                                    200, 2, UNKNOWN, new Refusal(Refusal.Reason.UNKNOWN_SENSOR, "nose"))),
                    commands);
        }
    }

    @Test
    void healthAndRungsAreLoggedWhenTheyChange() {
        List<SimulationSetup.TimedCommand> timeline = List.of(
                new SimulationSetup.TimedCommand(5, new Command.SwitchSensor("left", false)),
                new SimulationSetup.TimedCommand(9, new Command.SwitchSensor("left", true)));
        try (Session session = Session.start(setup(timeline))) {
            List<RunEvent> events = events(runTo(session, TICKS)).stream()
                    .filter(event -> event instanceof RunEvent.RungChanged
                            || event instanceof RunEvent.HealthChanged change
                                    && (change.from() == SensorTrust.DISTRUSTED
                                            || change.health().trust() == SensorTrust.DISTRUSTED))
                    .toList();
            SensorHealth off =
                    new SensorHealth("left", SensorTrust.DISTRUSTED, SensorFinding.OFF, evidence(events.get(0)), 500);
            assertEquals(new RunEvent.HealthChanged(501, 5.01, SensorTrust.TRUSTED, off), events.get(0));
            assertEquals(new RunEvent.RungChanged(501, 5.01, "ALL", "THREE"), events.get(1));
            RunEvent.HealthChanged again = (RunEvent.HealthChanged) events.get(2);
            assertEquals(
                    List.of("left", SensorTrust.TRUSTED),
                    List.of(again.health().sensor(), again.health().trust()));
            assertTrue(again.time() > 12 && again.time() < 40, "a while after it answers again: " + again.time());
            assertEquals(new RunEvent.RungChanged(again.tick(), again.time(), "THREE", "ALL"), events.get(3));
            assertEquals(4, events.size());
            assertTrue(session.journal().join().entries().isEmpty(), "what a diagnosis finds is no command");
        }
    }

    private static double evidence(RunEvent event) {
        return ((RunEvent.HealthChanged) event).health().evidence();
    }

    @Test
    void commandsGivenWhilePausedAreLoggedAtOnceWithTheComingTick() {
        try (Session session = Session.start(setup(List.of()))) {
            session.send(OFF);
            session.send(UNKNOWN);
            while (session.frame().recording().events().endIndex() < 2) {
                LockSupport.parkNanos(100_000);
            }
            assertEquals(
                    List.of(
                            new RunEvent.CommandExecuted(1, 0.01, OFF),
                            new RunEvent.CommandRefused(
                                    1, 0.01, UNKNOWN, new Refusal(Refusal.Reason.UNKNOWN_SENSOR, "nose"))),
                    events(session.frame()));
        }
    }

    @Test
    void theCollisionIsLoggedOnce() {
        SimulationSetup blind = SimulationSetup.of(room.world(), new Pose(0.6, 0.6, 0))
                .withRobot(room.robot())
                .withController(new ControllerSpec.Drive(3, 3))
                .withDuration(60);
        try (Session session = Session.start(blind)) {
            SessionFrame frame = runTo(session, 2000);
            List<RunEvent> events = events(frame);
            assertEquals(1, events.size());
            assertEquals(frame.snapshot().collision(), Optional.of(((RunEvent.Collided) events.get(0)).collision()));
        }
    }

    /** Such as a controller that reports its distance as its state. */
    @Test
    void theStatesOfAControllerThatNamesANewOneInEveryTickAreLimited() {
        int limit = StateTally.MAX_COUNTS;
        List<String> names = new ArrayList<>();
        LongStream.range(0, 2 * limit).forEach(i -> names.addAll(List.of("d=" + i, "d=1")));
        names.addAll(List.of("FOLLOW", "ROUND", "FOLLOW", "FOLLOW"));
        Telemetry[] telemetry = {Telemetry.ofState(ControllerState.of("NONE"))};
        Controller controller = observation -> {
            telemetry[0] = telemetry[0].entering(names.get((int) observation.tick()), "", observation.tick());
            return new Decision(0, 0, telemetry[0]);
        };
        Recorder recorder = new Recorder(room);
        try (Simulation simulation = new Simulation(room, controller, ControllerMode.DIRECT, recorder)) {
            recorder.observe(simulation);
            for (int i = 0; i < names.size(); i++) {
                simulation.tick();
                recorder.observe(simulation);
            }
        }
        StateTally tally = recorder.view().stateTally();
        assertEquals(limit + 2, tally.states().size());
        assertEquals(limit + 2, tally.transitions().size());
        ControllerState repeated = ControllerState.of("d=1");
        assertEquals(2 * limit + 1, tally.visitsTo(repeated).orElseThrow().ticks());
        assertEquals(3, tally.visitsTo(FollowerState.FOLLOW).orElseThrow().ticks());
        assertEquals(1, tally.visitsTo(FollowerState.ROUND).orElseThrow().visits());
        assertEquals(1, tally.transitionCount(FollowerState.FOLLOW, FollowerState.ROUND));
        assertEquals(1, tally.transitionCount(FollowerState.ROUND, FollowerState.FOLLOW));
        assertEquals(1, tally.transitionCount(repeated, ControllerState.of("d=5")));
        assertEquals(Optional.empty(), tally.visitsTo(ControllerState.of("d=" + limit)));
    }

    @Test
    void timeInStatesAndTransitionsAddUp() {
        try (Session session = Session.start(room)) {
            SessionFrame frame = runTo(session, TICKS);
            StateTally tally = frame.recording().stateTally();
            assertEquals(
                    frame.snapshot().tick(),
                    tally.states().stream()
                            .mapToLong(StateTally.StateVisits::ticks)
                            .sum());
            assertEquals(
                    frame.telemetry().transitions(),
                    tally.transitions().stream()
                            .mapToLong(StateTally.TransitionCount::count)
                            .sum());
            assertEquals(
                    1 + frame.telemetry().transitions(),
                    tally.states().stream()
                            .mapToLong(StateTally.StateVisits::visits)
                            .sum(),
                    "the start and each transition is a visit");
            List<Moment> moments = moments(room, (int) frame.snapshot().tick());
            long inFollow = moments.stream()
                    .filter(moment -> moment.tick() > 0 && moment.state() == FollowerState.FOLLOW)
                    .count();
            assertEquals(
                    inFollow, tally.visitsTo(FollowerState.FOLLOW).orElseThrow().ticks());
            assertEquals(1, tally.transitionCount(FollowerState.SEARCH, FollowerState.TURN));
            assertEquals(0, tally.transitionCount(FollowerState.FOLLOW, FollowerState.ALIGN));
        }
    }

    @Test
    void keyframesAreEvenlySpacedTrueMomentsAndNeverTooMany() {
        try (Session session = Session.start(room)) {
            SessionFrame frame = runTo(session, TICKS);
            Keyframes keyframes = frame.recording().keyframes();
            List<Moment> moments = moments(room, (int) frame.snapshot().tick());
            assertTrue(keyframes.size() <= KeyframeRecorder.MAX_FRAMES
                    && keyframes.size() >= KeyframeRecorder.MAX_FRAMES / 2);
            long newest =
                    keyframes.frameAt(Long.MAX_VALUE).orElseThrow().snapshot().tick();
            long stride = newest / (keyframes.size() - 1);
            for (long tick = 0; tick < frame.snapshot().tick(); tick += 100) {
                Frame key = keyframes.frameAt(tick).orElseThrow();
                assertEquals(tick / stride * stride, key.snapshot().tick());
                assertEquals(moments.get((int) key.snapshot().tick()).hash(), key.trajectoryHash());
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
            assertEquals(1023, early.frameAt(1023).orElseThrow().snapshot().tick());
            assertEquals(
                    1022, recorder.view().frameAt(1023).orElseThrow().snapshot().tick());
            assertEquals(
                    1024, recorder.view().frameAt(1025).orElseThrow().snapshot().tick());
            assertEquals(
                    1024, recorder.view().frameAt(9999).orElseThrow().snapshot().tick(), "the newest frame");
            assertNotEquals(early.size(), recorder.view().size());
        }
    }

    /** Returns the events of a run of eight ticks whose telemetry is given by the tick of the observation. */
    private List<RunEvent> events(LongFunction<Telemetry> telemetry) {
        SimulationSetup setup = setup(List.of());
        Controller controller = observation -> new Decision(0, 0, telemetry.apply(observation.tick()));
        Recorder recorder = new Recorder(setup);
        try (Simulation simulation = new Simulation(setup, controller, ControllerMode.DIRECT, recorder)) {
            recorder.observe(simulation);
            while (simulation.ticks() < 8) {
                simulation.tick();
                recorder.observe(simulation);
            }
        }
        EventLog log = recorder.view().events();
        return LongStream.range(log.firstIndex(), log.endIndex())
                .mapToObj(log::get)
                .toList();
    }

    private static Telemetry telemetry(ControllerState state, String why, int transitions, List<SensorHealth> health) {
        return new Telemetry(
                state,
                why,
                0,
                transitions,
                Telemetry.WallControl.NONE,
                Telemetry.EdgeTimes.NONE,
                new Telemetry.Diagnosis("", health));
    }

    @Test
    void aTransitionToTheSameStateAndOneThatIsNotCountedAreEvents() {
        Telemetry start = telemetry(FollowerState.SEARCH, "", 0, List.of());
        Telemetry again = telemetry(FollowerState.SEARCH, "again", 1, List.of());
        Telemetry turn = telemetry(FollowerState.TURN, "wall", 1, List.of());
        assertEquals(
                List.of(
                        new RunEvent.StateChanged(4, 0.04, FollowerState.SEARCH, FollowerState.SEARCH, "again"),
                        new RunEvent.StateChanged(7, 0.07, FollowerState.SEARCH, FollowerState.TURN, "wall")),
                events(tick -> tick < 3 ? start : tick < 6 ? again : turn));
    }

    @Test
    void onlySensorsWhoseTrustChangesHaveEvents() {
        SensorHealth front = new SensorHealth("front", SensorTrust.DISTRUSTED, SensorFinding.OFF, 1, 3);
        List<SensorHealth> trusted = List.of(SensorHealth.trusted("front"), SensorHealth.trusted("left"));
        List<SensorHealth> off = List.of(front, SensorHealth.trusted("left"));
        assertEquals(
                List.of(
                        new RunEvent.HealthChanged(4, 0.04, SensorTrust.TRUSTED, front),
                        new RunEvent.HealthChanged(7, 0.07, SensorTrust.DISTRUSTED, trusted.get(0))),
                events(tick -> telemetry(FollowerState.SEARCH, "", 0, tick < 3 || tick >= 6 ? trusted : off)));
    }
}
