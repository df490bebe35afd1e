package faultline.engine;

import faultline.world.Command;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongPredicate;

/**
 * An interactive run: owns the world thread and the controller's, takes commands and orders from any thread without ever blocking the caller, and
 * publishes frames. It starts paused. A restart is a new session from the same setup; a step back is a new session that replays the journal of the old one.
 */
public final class Session implements AutoCloseable {

    private static final long NO_END = -1;

    private final Queue<Consumer<LiveRun>> orders = new ConcurrentLinkedQueue<>();
    private final AtomicReference<Frame> newest = new AtomicReference<>();
    private final AtomicReference<Status> status;
    private final Thread thread;
    private final Pacer pacer = new Pacer();
    private volatile boolean frameWanted;
    private volatile boolean closed;

    // The world thread's own.
    private boolean running;
    private long end = NO_END;
    private boolean changed;
    private int refusals;
    private Optional<String> lastRefusal = Optional.empty();
    private Optional<String> failure = Optional.empty();

    private Session(LiveRun run) {
        newest.set(run.frame());
        status = new AtomicReference<>(describe());
        thread = new Thread(() -> live(run), "faultline-world");
        thread.setDaemon(true);
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
     * Starts a session where an earlier run was at the end of a tick, paused, with all that is remembered of the way there. It takes as long as the run needs to
     * come there, at full speed. What the journal has for later ticks is done when they come, until a new command is carried out: from then on this is another run.
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
        session.thread.start();
        return session;
    }

    /**
     * The newest frame; asking also orders the next one, so that none is built when nobody looks. Wait-free.
     *
     * @return the frame
     */
    public Frame frame() {
        frameWanted = true;
        return newest.get();
    }

    /**
     * Gives a command, which is applied and journaled at the start of the next tick; while paused, its effect shows in the next frame at once.
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
        order(run -> told.accept(commands.stream().map(command -> carryOut(run, command)).toList()));
    }

    private Outcome carryOut(LiveRun run, Command command) {
        List<Command> undo = run.undoing(command);
        Optional<String> refusal = run.apply(command);
        if (refusal.isPresent()) {
            refusals++;
            lastRefusal = refusal;
        }
        changed = true;
        return new Outcome(run.ticks() + 1, command, undo, refusal);
    }

    /** Lets time run. */
    public void run() {
        order(run -> {
            running = failure.isEmpty();
            pacer.restart();
        });
    }

    /** Holds time. */
    public void pause() {
        order(run -> running = false);
    }

    /**
     * Holds time once, as soon as a tick has passed; run on, it does not stop there again.
     *
     * @param tick later than now
     */
    public void holdAt(long tick) {
        order(run -> end = tick);
    }

    /** Forgets where to hold. */
    public void holdNowhere() {
        holdAt(NO_END);
    }

    /** Makes one tick and holds. */
    public void step() {
        order(run -> {
            running = false;
            if (failure.isEmpty()) {
                tick(run);
            }
        });
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
        order(run -> pacer.setSpeed(factor));
    }

    /**
     * How the session is.
     *
     * @return a value of this moment
     */
    public Status status() {
        return status.get();
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
        order(run -> journal.complete(question.apply(run)));
        if (closed) {
            journal.completeExceptionally(new IllegalStateException("the session is closed"));
        }
        return journal;
    }

    /** Ends the session and its threads; frames already taken stay good. */
    @Override
    public void close() {
        closed = true;
        LockSupport.unpark(thread);
    }

    private void order(Consumer<LiveRun> order) {
        orders.add(order);
        LockSupport.unpark(thread);
    }

    private void live(LiveRun run) {
        try (run) {
            while (!closed) {
                obey(run);
                if (running) {
                    tick(run);
                }
                publish(run);
                rest();
            }
            // What was asked before the end is answered.
            obey(run);
        }
    }

    private void obey(LiveRun run) {
        Consumer<LiveRun> order = orders.poll();
        while (order != null) {
            try {
                order.accept(run);
            } catch (RuntimeException broken) {
                fail(broken, run);
            }
            order = orders.poll();
        }
    }

    private void tick(LiveRun run) {
        try {
            run.tick();
            pacer.ticked(run.dt());
            changed = true;
            running = running && run.ticks() != end;
        } catch (RuntimeException broken) {
            fail(broken, run);
        }
    }

    private void fail(RuntimeException broken, LiveRun run) {
        running = false;
        failure = Optional.of(broken instanceof RunFailedException
                ? broken.getMessage() : "the run broke at tick " + run.ticks() + ": " + broken);
    }

    private void publish(LiveRun run) {
        if (changed && (frameWanted || !running)) {
            frameWanted = false;
            changed = false;
            if (!running) {
                run.look();
            }
            newest.set(run.frame());
        }
        Status now = describe();
        if (!now.equals(status.get())) {
            status.set(now);
        }
    }

    private Status describe() {
        return new Status(running, pacer.speed(), running ? pacer.achieved() : 0, refusals, lastRefusal, failure);
    }

    /** Waits for the next tick's moment, or for an order. */
    private void rest() {
        if (!orders.isEmpty() || closed) {
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
