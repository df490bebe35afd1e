package faultline.engine.session;

import faultline.engine.Journal;
import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.LongPredicate;
import java.util.function.Supplier;

/**
 * An interactive run. A session has a simulation thread and a controller thread; its public methods may be called from
 * any thread. Those of a session do not block, except {@link #awaitEnd}; those that start one run its first ticks. The
 * simulation thread runs submitted tasks between ticks, makes ticks at the requested speed, and publishes frames and
 * the status. A session starts paused. A restart is a new session with the same setup; a step back is a new session
 * that replays the journal of the old one.
 */
public final class Session implements SessionView, AutoCloseable {

    private final SessionRequests requests = new SessionRequests();
    private final AtomicReference<SessionFrame> latestFrame = new AtomicReference<>();
    private final AtomicReference<SessionStatus> latestStatus = new AtomicReference<>();
    private final Thread thread = new Thread(this::runSession, "faultline-world");
    private final TickWatch watch = new TickWatch(thread);
    private volatile boolean frameWanted;
    private volatile boolean closed;
    private volatile boolean ended;
    private volatile Runnable pausedChangeListener = () -> {};

    /** Used by the simulation thread only, after the replay. */
    private final InteractiveRun run;

    private Session(InteractiveRun run) {
        this.run = run;
        thread.setDaemon(true);
    }

    /**
     * Starts a session, paused at tick 0. Its first frame is available at once.
     *
     * @param setup the setup of the run
     * @return the session, which the caller closes
     * @throws RunFailedException if the controller cannot be started, threw an exception or did not answer
     */
    public static Session start(SimulationSetup setup) {
        return start(new Journal(setup, List.of(), 0), 0, run -> {}, tick -> true);
    }

    /**
     * Replays an earlier run on the calling thread, at full speed, and starts a session there, paused, with the
     * recording of the replay. The journal's commands for the next tick are then executed: a run that is edited while
     * it is paused at a tick has them at the start of the next one. Later commands are executed when their ticks come,
     * until a new command is executed. A cancellation takes effect when the current tick, or the construction of the
     * world, is complete.
     *
     * @param journal the earlier run, as returned by {@link #fullJournal}
     * @param tick the tick to replay to, not negative
     * @param shouldContinue called after each replayed tick with that tick; false cancels the replay
     * @return the session; its first frame is available at once
     * @throws RunFailedException if the controller threw an exception or did not answer
     * @throws CancellationException if the replay was cancelled
     */
    public static Session replay(Journal journal, long tick, LongPredicate shouldContinue) {
        return start(journal, tick, InteractiveRun::executeNextCommands, shouldContinue);
    }

    /**
     * Replays an earlier run with a changed setup as {@link #replay} does, and also executes the timeline's commands
     * for the next tick: the change may have moved commands from the journal to the timeline.
     *
     * @param journal the earlier run with the changed setup
     * @param tick the tick to replay to, not negative
     * @param shouldContinue called after each replayed tick with that tick; false cancels the replay
     * @return the session; its first frame is available at once
     * @throws RunFailedException if the controller threw an exception or did not answer
     * @throws CancellationException if the replay was cancelled
     */
    public static Session resimulate(Journal journal, long tick, LongPredicate shouldContinue) {
        return start(
                journal,
                tick,
                run -> {
                    run.executeDueCommands();
                    run.executeNextCommands();
                },
                shouldContinue);
    }

    private static Session start(
            Journal journal, long tick, Consumer<InteractiveRun> afterReplay, LongPredicate shouldContinue) {
        InteractiveRun run = new InteractiveRun(journal);
        try {
            run.replayTo(tick, shouldContinue);
            afterReplay.accept(run);
        } catch (RuntimeException | Error e) {
            run.close();
            throw e;
        }
        Session started = new Session(run);
        started.latestFrame.set(run.frame());
        started.latestStatus.set(run.status());
        started.thread.start();
        return started;
    }

    @Override
    public SimulationSetup setup() {
        return run.setup();
    }

    @Override
    public SessionFrame frame() {
        frameWanted = true;
        return latestFrame.get();
    }

    /**
     * Sends a command, which is executed and journaled at the start of the next tick. While the session is paused, the
     * next frame shows its effect. A {@link Command.ConfigureSensor} leaves the sensor's switch alone: its result and
     * the journal have the switch that the sensor has at that tick.
     *
     * @param command the command
     */
    public void send(Command command) {
        send(List.of(command), results -> {});
    }

    /**
     * Sends commands, which are executed in order at the start of the same tick. Unless all are refused, the run no
     * longer follows a replayed journal.
     *
     * @param commands the commands
     * @param resultHandler receives the result of each command, on the simulation thread, after a frame that shows its
     *     effect has been published; none if the run broke at one of them; must return quickly
     */
    public void send(List<Command> commands, Consumer<List<CommandResult>> resultHandler) {
        submit(() -> {
            List<CommandResult> results = List.of();
            try {
                results = run.execute(commands);
            } finally {
                List<CommandResult> answer = results;
                requests.addAnswer(() -> resultHandler.accept(answer));
            }
        });
    }

    /** Resumes the run. */
    public void resume() {
        submit(() -> run.setRunning(true));
    }

    /** Pauses the run. */
    public void pause() {
        submit(() -> run.setRunning(false));
    }

    /**
     * Pauses the run if it is running, and resumes it if it is paused. A run that was seen running and has paused in
     * the meantime stays paused.
     *
     * @param seenRunning whether the user has seen the run running
     */
    public void toggleRunning(boolean seenRunning) {
        submit(() -> run.setRunning(!run.isRunning() && !seenRunning));
    }

    /**
     * Pauses the run once, at the end of a later tick.
     *
     * @param tick the tick
     */
    public void pauseAt(long tick) {
        submit(() -> run.pauseAt(tick));
    }

    /** Makes one tick and pauses. */
    public void step() {
        submit(() -> watch.execute(run::step));
    }

    /**
     * Sets the requested speed.
     *
     * @param factor multiple of real time, positive; positive infinity for full speed
     * @throws IllegalArgumentException if it is not positive
     */
    public void setSpeed(double factor) {
        if (!(factor > 0)) {
            throw new IllegalArgumentException("the speed must be positive: " + factor);
        }
        submit(() -> run.setSpeed(factor));
    }

    @Override
    public SessionStatus status() {
        return latestStatus.get();
    }

    @Override
    public void setPausedChangeListener(Runnable listener) {
        pausedChangeListener = listener;
    }

    /**
     * {@return the commands executed so far} The future completes on the simulation thread between two ticks, or
     * exceptionally if the session is closed before.
     */
    public CompletableFuture<Journal> journal() {
        return requestJournal(run::journal);
    }

    /** {@return the commands executed so far and those still to be replayed; completes as {@link #journal}} */
    public CompletableFuture<Journal> fullJournal() {
        return requestJournal(run::fullJournal);
    }

    private CompletableFuture<Journal> requestJournal(Supplier<Journal> request) {
        CompletableFuture<Journal> journal = new CompletableFuture<>();
        submit(() -> {
            Journal now = request.get();
            requests.addAnswer(() -> journal.complete(now));
        });
        if (closed) {
            journal.completeExceptionally(new IllegalStateException("the session is closed"));
        }
        return journal;
    }

    /**
     * {@return whether the simulation thread has ended, after {@link #close} or by an error such as a lack of memory}
     * Later requests have no effect, and commands are not answered.
     */
    public boolean hasEnded() {
        return ended;
    }

    /**
     * Lets the run fail if its controller does not answer within a second, so that the session can answer the requests
     * that it has got. A controller in another process is then ended.
     */
    public void stopWaiting() {
        CompletableFuture<Void> answered = new CompletableFuture<>();
        submit(() -> requests.addAnswer(() -> answered.complete(null)));
        watch.limit(answered);
    }

    /** Ends the session and its threads, without waiting for a controller that does not answer. Frames stay valid. */
    @Override
    public void close() {
        closed = true;
        stopWaiting();
    }

    /**
     * Waits until the session has ended and its controller is closed.
     *
     * @param millis the maximum time to wait, milliseconds, positive
     * @throws InterruptedException if the calling thread is interrupted
     */
    public void awaitEnd(long millis) throws InterruptedException {
        thread.join(millis);
    }

    /** Submits a task that runs on the simulation thread between two ticks. */
    private void submit(Runnable task) {
        requests.add(task);
        LockSupport.unpark(thread);
    }

    // The methods below are called only by the simulation thread.

    private void runSession() {
        try (run) {
            runUntilClosed();
        } catch (RuntimeException | Error broken) {
            run.fail(broken);
            latestStatus.set(run.status());
            throw broken;
        } finally {
            closed = true;
            try {
                // Requests that were submitted before the end are still answered.
                requests.execute(run::fail);
                requests.sendAnswers();
            } finally {
                ended = true;
            }
        }
    }

    private void runUntilClosed() {
        while (!closed) {
            requests.execute(run::fail);
            if (run.isRunning()) {
                watch.execute(run::tick);
            }
            publish();
            awaitNextTick();
        }
    }

    private void publish() {
        boolean changed = false;
        if (run.isFrameOutdated() && (frameWanted || !run.isRunning() || requests.hasAnswers())) {
            frameWanted = false;
            latestFrame.set(run.frame());
            changed = true;
        }
        SessionStatus now = run.status();
        SessionStatus before = latestStatus.get();
        if (!now.equals(before)) {
            latestStatus.set(now);
            changed = true;
        }
        requests.sendAnswers();
        if (changed && !(now.running() && before.running())) {
            pausedChangeListener.run();
        }
    }

    /** Waits until the next tick is due or a task is submitted. */
    private void awaitNextTick() {
        if (requests.isEmpty() && !closed) {
            if (run.isRunning()) {
                run.awaitTick();
            } else {
                LockSupport.park(this);
            }
        }
    }
}
