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
 * An interactive run: has a world thread and a controller's, takes commands and orders from any thread without ever
 * blocking the caller, and publishes frames. It starts paused. A restart is a new session from the same setup; a step
 * back is a new session that replays the journal of the old one.
 */
public final class Session implements AutoCloseable {

    private final SimulationThread simulationThread;

    private Session(RecordedSimulation run) {
        simulationThread = new SimulationThread(run);
    }

    /**
     * Starts a session, paused at tick 0.
     *
     * @param setup what to run
     * @return the session, its first frame published
     */
    public static Session start(SimulationSetup setup) {
        return replay(new Journal(setup, List.of(), 0), 0, tick -> true);
    }

    /**
     * Starts a session where an earlier run was at the end of a tick, paused, with all that is remembered of the way
     * there. It takes as long as the run needs to come there, at full speed. What the journal has for later ticks is
     * done when they come, until a new command is carried out: from then on this is another run.
     *
     * @param journal of the earlier run, as {@link #fullJournal} gives it
     * @param tick not negative
     * @param onward asked after each tick on the way, on the calling thread, whether to go on; given the tick
     * @return the session, its first frame published
     * @throws RunFailedException if the controller threw or did not answer on the way
     * @throws java.util.concurrent.CancellationException if it was not to go on
     */
    public static Session replay(Journal journal, long tick, LongPredicate onward) {
        Session session = new Session(RecordedSimulation.replayTo(journal, tick, onward));
        session.simulationThread.start();
        return session;
    }

    /**
     * The newest frame; asking also orders the next one, so that none is built when nobody looks. Wait-free.
     *
     * @return the frame
     */
    public SessionFrame frame() {
        return simulationThread.frame();
    }

    /**
     * Gives a command, which is applied and journaled at the start of the next tick; while paused, its effect shows in
     * the next frame at once.
     *
     * @param command what is to be done
     */
    public void send(Command command) {
        send(List.of(command), outcomes -> {});
    }

    /**
     * Gives several commands, which are applied one after the other at the start of the same tick.
     *
     * @param commands what is to be done
     * @param told gets what became of each, on the world thread; it must be quick
     */
    public void send(List<Command> commands, Consumer<List<CommandResult>> told) {
        simulationThread.submit(
                world -> told.accept(commands.stream().map(world::execute).toList()));
    }

    /** Lets time run. */
    public void resume() {
        simulationThread.submit(SimulationThread::resume);
    }

    /** Holds time. */
    public void pause() {
        simulationThread.submit(SimulationThread::pause);
    }

    /**
     * Holds time once, as soon as a tick has passed; run on, it does not stop there again.
     *
     * @param tick later than now
     */
    public void pauseAt(long tick) {
        simulationThread.submit(world -> world.pauseAt(tick));
    }

    /** Forgets where to hold. */
    public void clearPauseTick() {
        simulationThread.submit(SimulationThread::clearPauseTick);
    }

    /** Makes one tick and holds. */
    public void step() {
        simulationThread.submit(SimulationThread::step);
    }

    /**
     * Sets the pace.
     *
     * @param factor times real time, positive; positive infinity for as fast as possible
     * @throws IllegalArgumentException if it is not positive
     */
    public void setSpeed(double factor) {
        if (!(factor > 0)) {
            throw new IllegalArgumentException("the speed must be positive: " + factor);
        }
        simulationThread.submit(world -> world.setSpeed(factor));
    }

    /**
     * How the session is.
     *
     * @return a value of this moment
     */
    public Status status() {
        return simulationThread.status();
    }

    /**
     * What was done so far, taken between two ticks.
     *
     * @return completed on the world thread, soon; exceptionally if the session is closed before
     */
    public CompletableFuture<Journal> journal() {
        return requestJournal(RecordedSimulation::journal);
    }

    /**
     * What was done so far, and what a session that replays an earlier run still has before it.
     *
     * @return completed on the world thread, soon; exceptionally if the session is closed before
     */
    public CompletableFuture<Journal> fullJournal() {
        return requestJournal(RecordedSimulation::fullJournal);
    }

    private CompletableFuture<Journal> requestJournal(Function<RecordedSimulation, Journal> question) {
        CompletableFuture<Journal> journal = new CompletableFuture<>();
        simulationThread.submit(world -> journal.complete(question.apply(world.simulation())));
        if (simulationThread.isClosed()) {
            journal.completeExceptionally(new IllegalStateException("the session is closed"));
        }
        return journal;
    }

    /** Ends the session and its threads; frames already taken stay good. */
    @Override
    public void close() {
        simulationThread.close();
    }

    /**
     * How a session is at one moment.
     *
     * @param running whether time runs
     * @param speed the pace asked for, times real time, positive infinity for as fast as possible
     * @param achievedSpeed the pace reached over the last half second, times real time; 0 while held
     * @param refusals how many commands were refused so far
     * @param lastRefusal why the last of them was
     * @param failure why the run broke off, empty while it is sound
     */
    public record Status(
            boolean running,
            double speed,
            double achievedSpeed,
            int refusals,
            Optional<Refusal> lastRefusal,
            Optional<String> failure) {}
}
