package faultline.engine;

import faultline.world.Command;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongPredicate;

/**
 * An interactive run: has a world thread and a controller's, takes commands and orders from any thread without ever blocking the caller,
 * and publishes frames. It starts paused. A restart is a new session from the same setup; a step back is a new session that replays the
 * journal of the old one.
 */
public final class Session implements AutoCloseable {

    private final WorldLoop loop;

    private Session(LiveRun run) {
        loop = new WorldLoop(run);
    }

    /**
     * Starts a session, paused at tick 0.
     *
     * @param setup what to run
     * @return the session, its first frame published
     */
    public static Session start(Setup setup) {
        return replay(new Journal(setup, List.of(), 0), 0, tick -> true);
    }

    /**
     * Starts a session where an earlier run was at the end of a tick, paused, with all that is remembered of the way there. It takes as
     * long as the run needs to come there, at full speed. What the journal has for later ticks is done when they come, until a new command
     * is carried out: from then on this is another run.
     *
     * @param journal of the earlier run, as {@link #wholeJournal} gives it
     * @param tick not negative
     * @param onward asked after each tick on the way, on the calling thread, whether to go on; given the tick
     * @return the session, its first frame published
     * @throws RunFailedException if the controller threw or did not answer on the way
     * @throws java.util.concurrent.CancellationException if it was not to go on
     */
    public static Session replay(Journal journal, long tick, LongPredicate onward) {
        Session session = new Session(LiveRun.at(journal, tick, onward));
        session.loop.start();
        return session;
    }

    /**
     * The newest frame; asking also orders the next one, so that none is built when nobody looks. Wait-free.
     *
     * @return the frame
     */
    public Frame frame() {
        return loop.frame();
    }

    /**
     * Gives a command, which is applied and journaled at the start of the next tick; while paused, its effect shows in the next frame at
     * once.
     *
     * @param command what is to be done
     */
    public void send(Command command) {
        send(List.of(command), outcomes -> { });
    }

    /**
     * Gives several commands, which are applied one after the other at the start of the same tick.
     *
     * @param commands what is to be done
     * @param told gets what became of each, on the world thread; it must be quick
     */
    public void send(List<Command> commands, Consumer<List<Outcome>> told) {
        loop.order(world -> told.accept(commands.stream().map(world::carryOut).toList()));
    }

    /** Lets time run. */
    public void run() {
        loop.order(WorldLoop::go);
    }

    /** Holds time. */
    public void pause() {
        loop.order(WorldLoop::hold);
    }

    /**
     * Holds time once, as soon as a tick has passed; run on, it does not stop there again.
     *
     * @param tick later than now
     */
    public void holdAt(long tick) {
        loop.order(world -> world.holdAt(tick));
    }

    /** Forgets where to hold. */
    public void holdNowhere() {
        loop.order(WorldLoop::holdNowhere);
    }

    /** Makes one tick and holds. */
    public void step() {
        loop.order(WorldLoop::step);
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
        loop.order(world -> world.setSpeed(factor));
    }

    /**
     * How the session is.
     *
     * @return a value of this moment
     */
    public Status status() {
        return loop.status();
    }

    /**
     * What was done so far, taken between two ticks.
     *
     * @return completed on the world thread, soon; exceptionally if the session is closed before
     */
    public CompletableFuture<Journal> journal() {
        return ask(LiveRun::journal);
    }

    /**
     * What was done so far, and what a session that replays an earlier run still has before it.
     *
     * @return completed on the world thread, soon; exceptionally if the session is closed before
     */
    public CompletableFuture<Journal> wholeJournal() {
        return ask(LiveRun::wholeJournal);
    }

    private CompletableFuture<Journal> ask(Function<LiveRun, Journal> question) {
        CompletableFuture<Journal> journal = new CompletableFuture<>();
        loop.order(world -> journal.complete(question.apply(world.live())));
        if (loop.isClosed()) {
            journal.completeExceptionally(new IllegalStateException("the session is closed"));
        }
        return journal;
    }

    /** Ends the session and its threads; frames already taken stay good. */
    @Override
    public void close() {
        loop.close();
    }

    /**
     * What became of a command.
     *
     * @param tick the tick at whose start it was carried out
     * @param command what was to be done
     * @param undo the commands, in order, that restore what it changed
     * @param refusal why it was refused, empty where it was done
     */
    public record Outcome(long tick, Command command, List<Command> undo, Optional<String> refusal) {
        public Outcome {
            undo = List.copyOf(undo);
        }
    }

    /**
     * How a session is at one moment.
     *
     * @param running whether time runs
     * @param speed the pace asked for, times real time, positive infinity for as fast as possible
     * @param achieved the pace reached over the last half second, times real time; 0 while held
     * @param refusals how many commands were refused so far
     * @param lastRefusal why the last of them was
     * @param failure why the run broke off, empty while it is sound
     */
    public record Status(boolean running, double speed, double achieved, int refusals, Optional<String> lastRefusal,
            Optional<String> failure) {
    }
}
