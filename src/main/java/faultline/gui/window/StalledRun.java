package faultline.gui.window;

import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import java.util.function.LongSupplier;

/** Notices that a run makes no more ticks although it is not paused: its controller does not answer. */
final class StalledRun {

    private static final double MIN_SECONDS = 2;
    private static final double NANOS_PER_SECOND = 1e9;

    private final LongSupplier nanoTime;
    private long tick = -1;
    private long since;

    StalledRun(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
    }

    /** Returns whether the run, as it is shown now, is stalled. */
    boolean isStalled(SessionFrame frame, SessionStatus status) {
        long now = nanoTime.getAsLong();
        if (!status.running() || frame.snapshot().tick() != tick) {
            tick = frame.snapshot().tick();
            since = now;
        }
        return (now - since) / NANOS_PER_SECOND > Math.max(MIN_SECONDS, 2 * frame.dt() / status.speed());
    }
}
