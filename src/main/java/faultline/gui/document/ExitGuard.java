package faultline.gui.document;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;

/** Keeps the program from ending before something is written: a window may be closed meanwhile. */
public final class ExitGuard {

    private ExitGuard() {}

    /**
     * Holds the program.
     *
     * @param work until it is done, in whatever way
     * @return the thread that does, which is no daemon
     */
    public static Thread keepAliveUntilDone(Future<?> work) {
        Thread guard = new Thread(() -> await(work), "faultline-guard");
        guard.setDaemon(false);
        guard.start();
        return guard;
    }

    private static void await(Future<?> work) {
        try {
            work.get();
        } catch (ExecutionException | CancellationException told) {
            // Those who wait for the result on the event dispatch thread are told.
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
    }
}
