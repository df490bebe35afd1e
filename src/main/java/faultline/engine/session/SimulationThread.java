package faultline.engine.session;

import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.metrics.RunMeter;
import faultline.engine.recording.Recorder;
import faultline.engine.session.Session.Status;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.LongPredicate;

/**
 * The thread of a session: runs submitted tasks between ticks, makes ticks at the requested speed, and publishes frames
 * and the status. Only the methods above {@link #run} may be called from other threads.
 */
final class SimulationThread implements Runnable {

    private static final long NO_PAUSE_TICK = -1;

    private final Queue<Consumer<SimulationThread>> tasks = new ConcurrentLinkedQueue<>();
    private final AtomicReference<SessionFrame> latestFrame = new AtomicReference<>();
    private final AtomicReference<Status> status = new AtomicReference<>();
    private final Thread thread = new Thread(this, "faultline-world");
    private volatile boolean frameWanted;
    private volatile boolean closed;

    // Used by the simulation thread only, after the replay.
    private final Simulation simulation;
    private final Recorder recorder;
    private final RunMeter meter;
    private final JournalPlayer player;
    private final Pacer pacer = new Pacer();
    private boolean running;
    private long pauseTick = NO_PAUSE_TICK;
    private boolean frameOutdated;
    private final Queue<Runnable> answers = new ArrayDeque<>();
    private int refusals;
    private Refusal lastRefusal;
    private String failure;

    private SimulationThread(Journal journal) {
        recorder = new Recorder(journal.setup());
        meter = new RunMeter(journal.setup());
        player = new JournalPlayer(journal);
        simulation = new Simulation(journal.setup(), ControllerMode.OWN_THREAD, recorder);
        recorder.observe(simulation);
        meter.observe(simulation);
        thread.setDaemon(true);
    }

    /**
     * Replays a journal up to a tick on the calling thread, at full speed, and starts the simulation thread there,
     * paused, before or after the commands for the next tick.
     */
    static SimulationThread start(Journal journal, long tick, boolean edited, LongPredicate shouldContinue) {
        SimulationThread made = new SimulationThread(journal);
        try {
            made.replayTo(tick, shouldContinue);
            if (edited) {
                made.player.executeCommands(made.simulation);
                made.simulation.resample();
            }
        } catch (RuntimeException e) {
            made.simulation.close();
            throw e;
        }
        made.latestFrame.set(made.currentFrame());
        made.status.set(made.currentStatus());
        made.thread.start();
        return made;
    }

    private void replayTo(long tick, LongPredicate shouldContinue) {
        while (simulation.ticks() < tick) {
            advance();
            if (!shouldContinue.test(simulation.ticks())) {
                throw new CancellationException("the replay was cancelled at tick " + simulation.ticks());
            }
        }
    }

    /** Submits a task that runs on the simulation thread between two ticks. */
    void submit(Consumer<SimulationThread> task) {
        tasks.add(task);
        LockSupport.unpark(thread);
    }

    /** Returns the latest frame and requests the next one. */
    SessionFrame frame() {
        frameWanted = true;
        return latestFrame.get();
    }

    Status status() {
        return status.get();
    }

    void close() {
        closed = true;
        LockSupport.unpark(thread);
    }

    boolean isClosed() {
        return closed;
    }

    @Override
    public void run() {
        try (simulation) {
            while (!closed) {
                runTasks();
                if (running) {
                    tick();
                }
                publish();
                awaitNextTick();
            }
            // Requests from before the end are still answered.
            runTasks();
            sendAnswers();
        }
    }

    private void runTasks() {
        for (Consumer<SimulationThread> task = tasks.poll(); task != null; task = tasks.poll()) {
            try {
                task.accept(this);
            } catch (RuntimeException e) {
                fail(e);
            }
        }
    }

    private void tick() {
        try {
            advance();
            pacer.tickCompleted(simulation.setup().dt());
            frameOutdated = true;
            running = running && simulation.ticks() != pauseTick;
        } catch (RuntimeException e) {
            fail(e);
        }
    }

    private void advance() {
        player.tick(simulation);
        recorder.observe(simulation);
        meter.observe(simulation);
    }

    private void fail(RuntimeException cause) {
        running = false;
        failure = cause instanceof RunFailedException
                ? cause.getMessage()
                : "the run broke at tick " + simulation.ticks() + ": " + cause;
    }

    private void publish() {
        if (frameOutdated && (frameWanted || !running || !answers.isEmpty())) {
            frameWanted = false;
            frameOutdated = false;
            if (!running) {
                simulation.resample();
            }
            latestFrame.set(currentFrame());
        }
        Status now = currentStatus();
        if (!now.equals(status.get())) {
            status.set(now);
        }
        sendAnswers();
    }

    /** Sends the answers to requests, in the order of the requests. */
    private void sendAnswers() {
        answers.forEach(Runnable::run);
        answers.clear();
    }

    private SessionFrame currentFrame() {
        return new SessionFrame(simulation.frame(), recorder.view(), meter.measures(), simulation.controllerSpec());
    }

    private Status currentStatus() {
        return new Status(running, pacer.speed(), running ? pacer.achievedSpeed() : 0, refusals, lastRefusal, failure);
    }

    /** Waits until the next tick is due or a task is submitted. */
    private void awaitNextTick() {
        if (!tasks.isEmpty() || closed) {
            return;
        }
        if (!running) {
            LockSupport.park(this);
        } else {
            long wait = pacer.nanosToWait();
            if (wait > 0) {
                LockSupport.parkNanos(this, wait);
            }
        }
    }

    // For tasks, on the simulation thread.

    Journal journal() {
        return simulation.journal();
    }

    Journal fullJournal() {
        return player.fullJournal(simulation);
    }

    /** Runs an answer to a request once the next frame, which shows the effect of the request, is published. */
    void afterPublishing(Runnable answer) {
        answers.add(answer);
    }

    /** Executes a command from outside. Unless it is refused, the run no longer follows the replayed journal. */
    CommandResult execute(Command command) {
        CommandResult result = simulation.execute(command);
        if (result.refusal().isPresent()) {
            refusals++;
            lastRefusal = result.refusal().get();
        } else {
            player.discardPending();
        }
        frameOutdated = true;
        return result;
    }

    void resume() {
        running = failure == null;
        pacer.restart();
    }

    void pause() {
        running = false;
    }

    void pauseAt(long tick) {
        pauseTick = tick;
    }

    void step() {
        running = false;
        if (failure == null) {
            tick();
        }
    }

    void setSpeed(double factor) {
        pacer.setSpeed(factor);
    }
}
