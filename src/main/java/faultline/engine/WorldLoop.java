package faultline.engine;

import faultline.engine.Session.Outcome;
import faultline.engine.Session.Status;
import faultline.world.Command;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * The life of a session's world thread: it obeys orders, makes ticks at the pace that is wanted, publishes what others look at, and rests.
 * Other threads may only order, look and close.
 */
final class WorldLoop implements Runnable {

    private static final long NO_END = -1;

    private final Queue<Consumer<WorldLoop>> orders = new ConcurrentLinkedQueue<>();
    private final AtomicReference<Frame> newest;
    private final AtomicReference<Status> status;
    private final Thread thread = new Thread(this, "faultline-world");
    private volatile boolean frameWanted;
    private volatile boolean closed;

    // The world thread's own.
    private final LiveRun run;
    private final Pacer pacer = new Pacer();
    private boolean running;
    private long end = NO_END;
    private boolean changed;
    private int refusals;
    private Optional<String> lastRefusal = Optional.empty();
    private Optional<String> failure = Optional.empty();

    WorldLoop(LiveRun run) {
        this.run = run;
        newest = new AtomicReference<>(run.frame());
        status = new AtomicReference<>(describe());
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    /** Has something done on the world thread, between two ticks. */
    void order(Consumer<WorldLoop> order) {
        orders.add(order);
        LockSupport.unpark(thread);
    }

    /** The newest frame; asking orders the next one. */
    Frame frame() {
        frameWanted = true;
        return newest.get();
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
        try (run) {
            while (!closed) {
                obey();
                if (running) {
                    tick();
                }
                publish();
                rest();
            }
            // What was asked before the end is answered.
            obey();
        }
    }

    private void obey() {
        Consumer<WorldLoop> order = orders.poll();
        while (order != null) {
            try {
                order.accept(this);
            } catch (RuntimeException broken) {
                fail(broken);
            }
            order = orders.poll();
        }
    }

    private void tick() {
        try {
            run.tick();
            pacer.ticked(run.dt());
            changed = true;
            running = running && run.ticks() != end;
        } catch (RuntimeException broken) {
            fail(broken);
        }
    }

    private void fail(RuntimeException broken) {
        running = false;
        failure = Optional.of(broken instanceof RunFailedException
                ? broken.getMessage() : "the run broke at tick " + run.ticks() + ": " + broken);
    }

    private void publish() {
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

    // Orders: on the world thread only.

    LiveRun live() {
        return run;
    }

    Outcome carryOut(Command command) {
        List<Command> undo = run.undoing(command);
        Optional<String> refusal = run.apply(command);
        if (refusal.isPresent()) {
            refusals++;
            lastRefusal = refusal;
        }
        changed = true;
        return new Outcome(run.ticks() + 1, command, undo, refusal);
    }

    void go() {
        running = failure.isEmpty();
        pacer.restart();
    }

    void hold() {
        running = false;
    }

    void holdAt(long tick) {
        end = tick;
    }

    void holdNowhere() {
        end = NO_END;
    }

    void step() {
        running = false;
        if (failure.isEmpty()) {
            tick();
        }
    }

    void setSpeed(double factor) {
        pacer.setSpeed(factor);
    }
}
