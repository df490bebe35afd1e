package faultline.engine.session;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** How long ticks may keep somebody waiting, if several are made before the request is answered. */
@Timeout(value = 1, unit = TimeUnit.MINUTES)
class TickWatchTest {

    private static final long PART = 300_000_000;
    private static final long WHOLE = 1_000_000_000;

    private final TickWatch watch = new TickWatch(Thread.currentThread());
    private final CompletableFuture<Void> answered = new CompletableFuture<>();

    @AfterEach
    void answer() {
        answered.complete(null);
    }

    /** Waits for some nanoseconds, or until an interrupt. Returns whether there was one. */
    private static boolean awaitInterrupt(long nanos) {
        long start = System.nanoTime();
        while (!Thread.currentThread().isInterrupted() && System.nanoTime() - start < nanos) {
            LockSupport.parkNanos(nanos);
        }
        return Thread.currentThread().isInterrupted();
    }

    @Test
    void eachTickMayTakeAWholeSecond() {
        watch.limit(answered);
        for (int tick = 0; tick < 5; tick++) {
            watch.execute(() -> assertFalse(awaitInterrupt(PART)));
        }
        long start = System.nanoTime();
        watch.execute(() -> assertTrue(awaitInterrupt(60 * WHOLE)));
        assertTrue(System.nanoTime() - start >= WHOLE, "the second tick was interrupted too early");
    }
}
