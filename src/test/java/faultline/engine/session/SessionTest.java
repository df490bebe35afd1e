package faultline.engine.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A session's orders, commands and frames, from a thread that is not its own. */
@Timeout(value = 1, unit = TimeUnit.MINUTES)
class SessionTest {

    private static final Obstacle POLE = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(3, 3, 0));

    private Session session;

    @BeforeEach
    void aPausedSession() {
        WorldSpec world = new WorldSpec(6, 4, true, 3, List.of(POLE));
        session = Session.start(SimulationSetup.of(world, new Pose(1, 1, 0)).withDuration(10));
    }

    @AfterEach
    void close() {
        session.close();
    }

    /** Waits for a condition that another thread brings about; the test's time limit is the deadline. */
    private static void await(BooleanSupplier condition) {
        while (!condition.getAsBoolean()) {
            LockSupport.parkNanos(100_000);
        }
    }

    private long tick() {
        return session.frame().snapshot().tick();
    }

    @Test
    void itStartsPausedWithAFrameOfTickZero() {
        assertEquals(0, tick());
        assertFalse(session.status().running());
        assertEquals(8, session.frame().snapshot().sensors().size());
    }

    @Test
    void aSessionWhoseThreadHasFailedSaysSoAndAnswersRequests() throws Exception {
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        BlockingQueue<Throwable> reported = new LinkedBlockingQueue<>();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> reported.add(failure));
        try {
            assertFalse(session.hasEnded());
            session.send(List.of(), results -> {
                throw new StackOverflowError("deep");
            });
            assertEquals("deep", reported.take().getMessage());
            assertTrue(session.hasEnded());
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
        assertEquals(
                "the run broke at tick 0: java.lang.StackOverflowError: deep",
                session.status().failure().orElseThrow().toString());
        CompletableFuture<Journal> journal = session.journal();
        assertThrows(ExecutionException.class, () -> journal.get(5, TimeUnit.SECONDS));
    }

    @Test
    void aCommandAtWhichTheRunBreaksIsAnswered() throws Exception {
        CompletableFuture<List<CommandResult>> results = new CompletableFuture<>();
        session.send(Collections.singletonList(null), results::complete);
        assertEquals(List.of(), results.get(5, TimeUnit.SECONDS));
        assertTrue(session.status().failure().orElseThrow().toString().contains("NullPointerException"));
    }

    @Test
    void aRunThatBrokeNeitherStepsNorResumes() throws Exception {
        CompletableFuture<List<CommandResult>> results = new CompletableFuture<>();
        session.send(Collections.singletonList(null), results::complete);
        results.get(5, TimeUnit.SECONDS);
        session.step();
        session.resume();
        assertEquals(0, session.journal().get(5, TimeUnit.SECONDS).ticks());
        assertFalse(session.status().running());
    }

    /** A controller that needs a permit for each decision from tick 2 on. */
    private static final class PermittedController implements ControllerSource {

        private final Semaphore permits = new Semaphore(0);
        private final AtomicLong observed = new AtomicLong();

        @Override
        public Controller start(RunConditions run) {
            return observation -> {
                observed.set(observation.tick());
                if (observation.tick() >= 2) {
                    permits.acquireUninterruptibly();
                }
                return new Decision(1, 1, Telemetry.ofState(FollowerState.SEARCH));
            };
        }

        @Override
        public boolean limitsAnswerTime() {
            return false;
        }
    }

    /** Replaces the session by one that waits for the decision of tick 2. */
    private PermittedController startWaiting() {
        session.close();
        PermittedController source = new PermittedController();
        session = Session.start(SimulationSetup.of(new WorldSpec(6, 4, true, 3, List.of(POLE)), new Pose(1, 1, 0))
                .withDuration(10)
                .withController(new ControllerSpec.Chosen(new ControllerSpec.Extern(0), source)));
        session.resume();
        await(() -> source.observed.get() == 2);
        return source;
    }

    @Test
    void aRunThatIsNotWaitedForFailsAndAnswersItsRequests() throws Exception {
        PermittedController controller = startWaiting();
        BlockingQueue<CommandResult> results = new LinkedBlockingQueue<>();
        session.send(List.of(new Command.RemoveObstacle("pole")), results::addAll);
        session.stopWaiting();
        assertEquals(Optional.empty(), results.take().refusal());
        assertEquals(
                "the run was interrupted at tick 2",
                session.status().failure().orElseThrow().toString());
        assertEquals(1, session.journal().get().entries().size());
        controller.permits.release();
    }

    @Test
    void aControllerThatAnswersSoonIsWaitedFor() {
        PermittedController controller = startWaiting();
        session.stopWaiting();
        long start = System.nanoTime();
        for (int tick = 2; System.nanoTime() - start < 1.3e9; tick++) {
            long observed = tick;
            await(() -> controller.observed.get() == observed);
            LockSupport.parkNanos(100_000_000);
            controller.permits.release();
        }
        assertEquals(Optional.empty(), session.status().failure());
        controller.permits.release(1000);
    }

    @Test
    void aStepMakesOneTickAndPauses() {
        session.step();
        session.step();
        await(() -> tick() == 2);
        assertFalse(session.status().running());
    }

    @Test
    void aToggleMeantAsAPauseDoesNotResumeARunThatHasPausedItself() throws Exception {
        session.toggleRunning(true);
        session.journal().get();
        assertFalse(session.status().running());
        session.toggleRunning(false);
        session.journal().get();
        assertTrue(session.status().running());
        session.toggleRunning(false);
        session.journal().get();
        assertFalse(session.status().running());
    }

    @Test
    void changesOfAPausedRunAreReportedWhenTheyAreVisible() {
        BlockingQueue<Long> ticks = new LinkedBlockingQueue<>();
        session.setPausedChangeListener(() -> ticks.add(tick()));
        session.step();
        await(() -> ticks.contains(1L));
        session.setSpeed(2);
        await(() -> session.status().speed() == 2 && ticks.size() == 2);
        session.resume();
        await(() -> tick() > 20);
        session.pause();
        await(() -> !session.status().running());
        // One report for the start and one for the end, none in between.
        await(() -> ticks.size() == 4);
        long last = tick();
        await(() -> ticks.contains(last));
    }

    /** A window that is not painted asks for no frames, and learns only by the report that there is one. */
    @Test
    void aStepOfAPausedRunIsReportedThoughNobodyHasAskedForAFrame() throws Exception {
        BlockingQueue<Long> ticks = new LinkedBlockingQueue<>();
        session.setPausedChangeListener(() -> ticks.add(1L));
        session.step();
        assertEquals(1L, ticks.poll(10, TimeUnit.SECONDS));
        assertEquals(1, tick());
    }

    @Test
    void whilePausedACommandShowsAtOnceAndTimeStands() {
        session.send(new Command.MoveObstacle("pole", new Pose(1.525, 1, 0)));
        await(() -> session.frame().snapshot().obstacles().get(0).pose().x() == 1.525);
        // Mounting position of the front sensor at 1.125, near side of the pole at 1.425.
        assertEquals(0.3, session.frame().snapshot().sensors().get(0).truth().encoded(), 1e-12);
        assertEquals(0, tick());
    }

    @Test
    void aRefusedCommandIsCountedAndExplainedAndNotJournaled() throws Exception {
        session.send(new Command.RemoveObstacle("ghost"));
        await(() -> session.status().refusals() == 1);
        assertEquals(
                "there is no obstacle ghost",
                session.status().lastRefusal().orElseThrow().message());
        assertTrue(session.journal().get().entries().isEmpty());
    }

    @Test
    void commandsGivenWhilePausedAreJournaledWithTheComingTick() throws Exception {
        session.step();
        session.send(new Command.SwitchSensor("left", false));
        assertEquals(
                List.of(new Journal.Entry(2, new Command.SwitchSensor("left", false))),
                session.journal().get().entries());
    }

    /** A busy machine makes the run slower, but nothing makes it faster. */
    @Test
    void atATenthOfRealTimeItIsNotFaster() {
        session.setSpeed(0.1);
        long start = System.nanoTime();
        session.resume();
        await(() -> tick() >= 10);
        // Nine waits of a tenth of a second.
        assertTrue((System.nanoTime() - start) / 1e9 >= 0.9, "the run did not wait");
    }

    @Test
    void atATickItPausesOnce() {
        session.setSpeed(Double.POSITIVE_INFINITY);
        session.pauseAt(30);
        session.resume();
        await(() -> tick() >= 30 && !session.status().running() || tick() > 100);
        assertEquals(30, tick());
        session.resume();
        await(() -> tick() > 30);
    }

    @Test
    void atFullSpeedItIsFasterThanRealTimeAndPausingStopsIt() {
        session.setSpeed(Double.POSITIVE_INFINITY);
        session.resume();
        await(() -> session.status().achievedSpeed() > 2);
        session.pause();
        await(() -> !session.status().running());
        await(() -> session.frame() == session.frame());
        long held = tick();
        session.step();
        await(() -> tick() == held + 1);
    }

    @Test
    void aSpeedThatIsNotPositiveIsRefusedAtOnce() {
        assertThrows(IllegalArgumentException.class, () -> session.setSpeed(0));
        assertThrows(IllegalArgumentException.class, () -> session.setSpeed(Double.NaN));
    }

    @Test
    void aClosedSessionStillCompletesEarlierRequests() throws Exception {
        session.step();
        var journal = session.journal();
        session.close();
        assertEquals(1, journal.get().ticks());
    }

    @Test
    void aPausedSessionThatIsClosedEndsItsThread() throws InterruptedException {
        Set<Thread> others = Thread.getAllStackTraces().keySet();
        Session own = Session.start(SimulationSetup.of(new WorldSpec(6, 4, true, 3, List.of()), new Pose(1, 1, 0)));
        List<Thread> threads = Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> !others.contains(thread) && thread.getName().startsWith("faultline-"))
                .toList();
        assertFalse(threads.isEmpty());
        assertTrue(threads.stream().allMatch(Thread::isDaemon), "the program can end");
        assertFalse(own.hasEnded());
        own.close();
        own.awaitEnd(TimeUnit.MINUTES.toMillis(1));
        assertTrue(own.hasEnded());
        for (Thread thread : threads) {
            thread.join();
        }
    }

    @Test
    void settingsOfASensorLeaveItsSwitchAsItIsInTheirTick() throws Exception {
        SimulationSetup setup = session.setup();
        SensorSpec left = setup.robot().sensor("left").orElseThrow();
        Command off = new Command.SwitchSensor("left", false);
        try (Session timed = Session.start(setup.withTimeline(List.of(new TimedCommand(setup.dt(), off))))) {
            CompletableFuture<List<CommandResult>> answer = new CompletableFuture<>();
            timed.send(List.of(new Command.ConfigureSensor(left.withRange(2))), answer::complete);
            SensorSpec longer = left.withRange(2).withOn(false);
            CommandResult executed = new CommandResult.Executed(
                    1, new Command.ConfigureSensor(longer), List.of(new Command.ConfigureSensor(left.withOn(false))));
            assertEquals(List.of(executed), answer.get());
            assertEquals(
                    List.of(new Journal.Entry(1, executed.command())),
                    timed.journal().get().entries());
            assertEquals(longer, timed.frame().snapshot().robot().sensor("left").orElseThrow());
        }
    }

    @Test
    void inverseCommandsComeWithTheResultsAndAreJournaledLikeThem() throws Exception {
        Pose elsewhere = new Pose(4, 3, 0);
        CompletableFuture<List<CommandResult>> answer = new CompletableFuture<>();
        session.send(
                List.of(new Command.MoveObstacle("pole", elsewhere), new Command.RemoveObstacle("sofa")),
                answer::complete);
        List<CommandResult> outcomes = answer.get();
        assertEquals(
                List.of(new Command.MoveObstacle("pole", POLE.pose())),
                outcomes.get(0).inverse());
        assertTrue(outcomes.get(0).refusal().isEmpty());
        assertEquals(List.of(), outcomes.get(1).inverse());
        assertTrue(outcomes.get(1).refusal().isPresent());
        session.send(outcomes.get(0).inverse(), ignored -> {});
        assertEquals(
                List.of(new Command.MoveObstacle("pole", elsewhere), new Command.MoveObstacle("pole", POLE.pose())),
                session.journal().get().entries().stream()
                        .map(Journal.Entry::command)
                        .toList());
        await(() -> session.status().refusals() == 1);
    }

    @Test
    void resultsComeAfterAFrameThatShowsTheirEffect() throws Exception {
        for (boolean running : List.of(false, true)) {
            CompletableFuture<Boolean> shown = new CompletableFuture<>();
            session.send(
                    List.of(new Command.SwitchSensor("left", running)),
                    results -> shown.complete(session.frame()
                                    .snapshot()
                                    .robot()
                                    .sensor("left")
                                    .orElseThrow()
                                    .on()
                            == running));
            assertTrue(shown.get());
            session.resume();
        }
    }
}
