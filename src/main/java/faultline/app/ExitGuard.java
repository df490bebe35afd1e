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
    private final Thread hook = new Thread(this::report, "faultline-exit-guard");
    /** Whether the run is over, so that an exit is the program's own. */
    private volatile boolean closed;

    private ExitGuard(CommandOutput output) {
        this.output = output;
    }

    /** Starts a guard, which reports to standard error until it is closed. */
    static ExitGuard start(CommandOutput output) {
        ExitGuard guard = new ExitGuard(output);
        ShutdownHooks.add(guard.hook);
        return guard;
    }

    /** Ends the process if a thread has called {@link System#exit} while this guard was open. */
    void report() {
        // In this order, because the program closes this guard before it exits.
        if (isExitCalled() && !closed) {
            output.printError("faultline: the run broke: the controller has ended the program by System.exit");
            // The process does not wait for the other hooks, of which one deletes these files.
            AtomicFile.deleteUnfinished();
            Runtime.getRuntime().halt(ExitCode.RUN_FAILED);
        }
    }

    /** Returns whether a thread has called {@link Runtime#exit}, in which it stays; a signal does not call it. */
    private static boolean isExitCalled() {
        return Thread.getAllStackTraces().values().stream()
                .flatMap(Arrays::stream)
                .anyMatch(frame -> frame.getClassName().equals("java.lang.Runtime")
                        && frame.getMethodName().equals("exit"));
    }

    @Override
    public void close() {
        closed = true;
        ShutdownHooks.remove(hook);
    }
}
