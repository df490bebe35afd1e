package faultline.engine.session;

import faultline.engine.RunFailedException;
import faultline.engine.session.Session.Status;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * The life of a session's world thread: it obeys orders, makes ticks at the pace that is wanted, publishes what others
 * look at, and rests. Other threads may only order, look and close.
 */
final class SimulationThread implements Runnable {

    private static final long NO_PAUSE_TICK = -1;

    private final Queue<Consumer<SimulationThread>> tasks = new ConcurrentLinkedQueue<>();
    private final AtomicReference<SessionFrame> latestFrame;
    private final AtomicReference<Status> status;
    private final Thread thread = new Thread(this, "faultline-world");
    private volatile boolean frameWanted;
    private volatile boolean closed;

    // The world thread's own.
    private final RecordedSimulation run;
    private final Pacer pacer = new Pacer();
    private boolean running;
    private long pauseTick = NO_PAUSE_TICK;
    private boolean frameOutdated;
    private int refusals;
    private Optional<Refusal> lastRefusal = Optional.empty();
    private Optional<String> failure = Optional.empty();

    SimulationThread(RecordedSimulation run) {
        this.run = run;
        latestFrame = new AtomicReference<>(run.frame());
        status = new AtomicReference<>(currentStatus());
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    /** Has something done on the world thread, between two ticks. */
    void submit(Consumer<SimulationThread> order) {
        tasks.add(order);
        LockSupport.unpark(thread);
    }

    /** The newest frame; asking orders the next one. */
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
        try (run) {
            while (!closed) {
                runTasks();
                if (running) {
                    tick();
                }
                publish();
                awaitNextTick();
            }
            // What was asked before the end is answered.
            runTasks();
        }
    }

    private void runTasks() {
        Consumer<SimulationThread> order = tasks.poll();
        while (order != null) {
            try {
                order.accept(this);
            } catch (RuntimeException broken) {
                fail(broken);
            }
            order = tasks.poll();
        }
    }

    private void tick() {
        try {
            run.tick();
            pacer.tickCompleted(run.dt());
            frameOutdated = true;
            running = running && run.ticks() != pauseTick;
        } catch (RuntimeException broken) {
            fail(broken);
        }
    }

    private void fail(RuntimeException broken) {
        running = false;
        failure = Optional.of(
                broken instanceof RunFailedException
                        ? broken.getMessage()
                        : "the run broke at tick " + run.ticks() + ": " + broken);
    }

    private void publish() {
        if (frameOutdated && (frameWanted || !running)) {
            frameWanted = false;
            frameOutdated = false;
            if (!running) {
                run.resample();
            }
            latestFrame.set(run.frame());
        }
        Status now = currentStatus();
        if (!now.equals(status.get())) {
            status.set(now);
        }
    }

    private Status currentStatus() {
        return new Status(running, pacer.speed(), running ? pacer.achievedSpeed() : 0, refusals, lastRefusal, failure);
    }

    /** Waits for the next tick's moment, or for an order. */
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

    // Orders: on the world thread only.

    RecordedSimulation simulation() {
        return run;
    }

    CommandResult execute(Command command) {
        CommandResult result = run.execute(command);
        if (result.refusal().isPresent()) {
            refusals++;
            lastRefusal = result.refusal();
        }
        frameOutdated = true;
        return result;
    }

    void resume() {
        running = failure.isEmpty();
        pacer.restart();
    }

    void pause() {
        running = false;
    }

    void pauseAt(long tick) {
        pauseTick = tick;
    }

    void clearPauseTick() {
        pauseTick = NO_PAUSE_TICK;
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
