package faultline.gui.window;

import faultline.engine.session.SessionStatus;
import faultline.world.Snapshot;
import java.util.function.LongSupplier;

/** Notices that a run makes no more ticks although it is not paused: its controller does not answer. */
final class StalledRun {

    private static final double MIN_SECONDS = 2;
    private static final double NANOS_PER_SECOND = 1e9;
    private static final double LONGEST_TICK = 1;

    private final LongSupplier nanoTime;
    private long tick = -1;
    private long since;

    StalledRun(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
    }

    /** Returns whether the run, as it is shown now, is stalled. */
    boolean isStalled(Snapshot world, SessionStatus status) {
        long now = nanoTime.getAsLong();
        if (!status.running() || world.tick() != tick) {
            tick = world.tick();
            since = now;
        }
        double length = tick > 0 ? world.time() / tick : LONGEST_TICK;
        return (now - since) / NANOS_PER_SECOND > Math.max(MIN_SECONDS, 2 * length / status.speed());
    }
}
