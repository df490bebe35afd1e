package faultline.engine.session;

import faultline.engine.Journal;
import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongPredicate;

/**
 * An interactive run. A session has a simulation thread and a controller thread; its methods may be called from any
 * thread and never block. It starts paused. A restart is a new session with the same setup; a step back is a new
 * session that replays the journal of the old one.
 */
public final class Session implements AutoCloseable {

    private final SimulationThread simulationThread;

    private Session(SimulationThread thread) {
        simulationThread = thread;
    }

    /**
     * Starts a session, paused at tick 0. Its first frame is available at once.
     *
     * @param setup the setup of the run
     * @return the session, which the caller closes
     */
    public static Session start(SimulationSetup setup) {
        return replay(new Journal(setup, List.of(), 0), 0, tick -> true);
    }

    /**
     * Replays an earlier run on the calling thread, at full speed, and starts a session there, paused, with the
     * recording of the replay. The journal's later commands are executed when their ticks come, until a new command is
     * executed.
     *
     * @param journal the earlier run, as returned by {@link #fullJournal}
     * @param tick the tick to replay to, not negative
     * @param shouldContinue called after each replayed tick with that tick; false cancels the replay
     * @return the session; its first frame is available at once
     * @throws RunFailedException if the controller threw an exception or did not answer
     * @throws java.util.concurrent.CancellationException if the replay was cancelled
     */
    public static Session replay(Journal journal, long tick, LongPredicate shouldContinue) {
        return new Session(SimulationThread.start(journal, tick, false, shouldContinue));
    }

    /**
     * Replays an earlier run as {@link #replay} does, and then executes the journal's commands for the next tick: a run
     * that is edited while it is paused at a tick has them at the start of the next one.
     *
     * @param journal the earlier run, as returned by {@link #fullJournal}
     * @param tick the tick to replay to, not negative
     * @param shouldContinue called after each replayed tick with that tick; false cancels the replay
     * @return the session; its first frame is available at once
     * @throws RunFailedException if the controller threw an exception or did not answer
     * @throws java.util.concurrent.CancellationException if the replay was cancelled
     */
    public static Session replayEdited(Journal journal, long tick, LongPredicate shouldContinue) {
        return new Session(SimulationThread.start(journal, tick, true, shouldContinue));
    }

    /** {@return the latest frame and requests the next one; frames are made only on request} Wait-free. */
    public SessionFrame frame() {
        return simulationThread.frame();
    }

    /**
     * Sends a command, which is executed and journaled at the start of the next tick. While the session is paused, the
     * next frame shows its effect.
     *
     * @param command the command
     */
    public void send(Command command) {
        send(List.of(command), results -> {});
    }

    /**
     * Sends commands, which are executed in order at the start of the same tick.
     *
     * @param commands the commands
     * @param resultHandler receives the result of each command, on the simulation thread, after a frame that shows its
     *     effect has been published; must return quickly
     */
    public void send(List<Command> commands, Consumer<List<CommandResult>> resultHandler) {
        simulationThread.submit(thread -> {
            List<CommandResult> results = commands.stream().map(thread::execute).toList();
            thread.afterPublishing(() -> resultHandler.accept(results));
        });
    }

    /** Resumes the run. */
    public void resume() {
        simulationThread.submit(SimulationThread::resume);
    }

    /** Pauses the run. */
    public void pause() {
        simulationThread.submit(SimulationThread::pause);
    }

    /**
     * Pauses the run once, at the end of a later tick.
     *
     * @param tick the tick
     */
    public void pauseAt(long tick) {
        simulationThread.submit(thread -> thread.pauseAt(tick));
    }

    /** Makes one tick and pauses. */
    public void step() {
        simulationThread.submit(SimulationThread::step);
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
        simulationThread.submit(thread -> thread.setSpeed(factor));
    }

    /** {@return the current status} */
    public Status status() {
        return simulationThread.status();
    }

    /**
     * {@return the commands executed so far} The future completes on the simulation thread between two ticks, or
     * exceptionally if the session is closed before.
     */
    public CompletableFuture<Journal> journal() {
        return requestJournal(SimulationThread::journal);
    }

    /** {@return the commands executed so far and those still to be replayed; completes as {@link #journal}} */
    public CompletableFuture<Journal> fullJournal() {
        return requestJournal(SimulationThread::fullJournal);
    }

    private CompletableFuture<Journal> requestJournal(Function<SimulationThread, Journal> request) {
        CompletableFuture<Journal> journal = new CompletableFuture<>();
        simulationThread.submit(thread -> {
            Journal now = request.apply(thread);
            thread.afterPublishing(() -> journal.complete(now));
        });
        if (simulationThread.isClosed()) {
            journal.completeExceptionally(new IllegalStateException("the session is closed"));
        }
        return journal;
    }

    /** Ends the session and its threads. Frames stay valid. */
    @Override
    public void close() {
        simulationThread.close();
    }

    /**
     * The status of a session at one moment.
     *
     * @param running whether the run advances
     * @param speed the requested speed, multiple of real time; positive infinity for full speed
     * @param achievedSpeed the speed over the last half second, multiple of real time; 0 while paused
     * @param refusals the number of refused commands so far
     * @param lastRefusalOrNull the last refusal, null if there was none
     * @param failureOrNull why the run failed, null if it did not
     */
    public record Status(
            boolean running,
            double speed,
            double achievedSpeed,
            int refusals,
            Refusal lastRefusalOrNull,
            String failureOrNull) {

        /** {@return the last refusal, if there was one} */
        public Optional<Refusal> lastRefusal() {
            return Optional.ofNullable(lastRefusalOrNull);
        }

        /** {@return why the run failed, if it did} */
        public Optional<String> failure() {
            return Optional.ofNullable(failureOrNull);
        }
    }
}
