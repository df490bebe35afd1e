package faultline.app;

import faultline.io.AtomicFile;
import faultline.io.ShutdownHooks;
import java.util.Arrays;

/**
 * Notices during a run that a controller in Java ends the process by {@link System#exit}, whose exit code would look
 * like that of the run. The process then ends with {@link ExitCode#RUN_FAILED} and a message. A signal is not affected.
 */
final class ExitGuard implements AutoCloseable {

    private final CommandOutput output;
    /** The thread of the run, which ends the process itself after it has closed this guard. */
    private final Thread owner = Thread.currentThread();

    private final Thread hook = new Thread(this::report, "faultline-exit-guard");
    /** Whether the run is over, so that an exit is the program's own. */
    private volatile boolean closed;

    private ExitGuard(CommandOutput output) {
        this.output = output;
    }

    /** Starts a guard of a run on this thread, which reports to standard error until it is closed. */
    static ExitGuard start(CommandOutput output) {
        ExitGuard guard = new ExitGuard(output);
        ShutdownHooks.add(guard.hook);
        return guard;
    }

    /**
     * Ends the process if a controller has called {@link System#exit}. Another hook may have ended the run in the
     * meantime, which closes this guard; only the owner may exit after that.
     */
    void report() {
        boolean ownerExits = isInExit(owner.getStackTrace());
        boolean otherExits = Thread.getAllStackTraces().entrySet().stream()
                .anyMatch(thread -> thread.getKey() != owner && isInExit(thread.getValue()));
        // Read last, because the owner closes this guard before it exits.
        if (otherExits || ownerExits && !closed) {
            output.printError("faultline: the run broke: the controller has ended the program by System.exit");
            // The process does not wait for the other hooks, of which one deletes these files.
            AtomicFile.deleteUnfinished();
            Runtime.getRuntime().halt(ExitCode.RUN_FAILED);
        }
    }

    /** Returns whether a thread has called {@link Runtime#exit}, in which it stays; a signal does not call it. */
    private static boolean isInExit(StackTraceElement[] stack) {
        return Arrays.stream(stack)
                .anyMatch(frame -> frame.getClassName().equals("java.lang.Runtime")
                        && frame.getMethodName().equals("exit"));
    }

    @Override
    public void close() {
        closed = true;
        ShutdownHooks.remove(hook);
    }
}
