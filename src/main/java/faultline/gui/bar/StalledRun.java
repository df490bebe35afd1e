package faultline.gui.bar;

import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import java.util.function.LongSupplier;

/**
 * Notices that a run makes no more ticks although it is not paused, or does not pause although the user wants it: its
 * controller does not answer.
 */
final class StalledRun {

    /** The shortest time without a tick after which a running run is stalled, seconds. */
    private static final double MIN_SECONDS = 2;
    /** The time after which a run that has not paused is stalled, seconds. An ordinary pause takes less. */
    private static final double PAUSE_SECONDS = 0.1;

    private static final double NANOS_PER_SECOND = 1e9;

    private final LongSupplier nanoTime;
    private long tick = -1;
    private long since;
    /** Whether the user has paused the run, and when for the first time, while it has not paused yet. */
    private boolean pausing;

    private long pausingSince;

    StalledRun(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
    }

    /** Notes that the user pauses the run. */
    void pauseRequested() {
        if (!pausing) {
            pausing = true;
            pausingSince = nanoTime.getAsLong();
        }
    }

    /** Forgets that the user has paused the run, because there is another one. */
    void reset() {
        pausing = false;
    }

    /** Returns whether the run, as it is shown now, is stalled. */
    boolean isStalled(SessionFrame frame, SessionStatus status) {
        long now = nanoTime.getAsLong();
        if (!status.running() || frame.snapshot().tick() != tick) {
            tick = frame.snapshot().tick();
            since = now;
            // The run was resumed before a pause was seen.
            pausing &= (now - pausingSince) / NANOS_PER_SECOND <= PAUSE_SECONDS;
        }
        pausing &= status.running();
        return (now - since) / NANOS_PER_SECOND > Math.max(MIN_SECONDS, 2 * frame.dt() / status.speed())
                || pausing && (now - Math.max(since, pausingSince)) / NANOS_PER_SECOND > PAUSE_SECONDS;
    }
}
