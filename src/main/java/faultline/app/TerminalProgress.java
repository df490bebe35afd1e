package faultline.app;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.LongSupplier;

/**
 * A bar that grows in its line, with the time left; shown only if a person can see it on a terminal. Must be closed
 * before anything else is printed.
 */
final class TerminalProgress implements AutoCloseable {

    private static final int BAR_WIDTH = 40;
    private static final long INTERVAL = 200_000_000;
    private static final double NANOS_PER_SECOND = 1e9;

    private final PrintStream out;
    private final boolean visible;
    private final LongSupplier clock;
    private final long start;
    private long shown;
    private long first = -1;

    /** Creates a bar with a clock, which returns nanoseconds from any moment on. */
    TerminalProgress(PrintStream out, boolean visible, LongSupplier clock) {
        this.out = out;
        this.visible = visible;
        this.clock = clock;
        start = clock.getAsLong();
        shown = start - INTERVAL;
    }

    /** Returns a bar for standard error, which shows nothing if that is not a terminal. */
    static TerminalProgress on(PrintStream err) {
        return new TerminalProgress(err, err == CommandOutput.STANDARD_ERROR && isTerminal(), System::nanoTime);
    }

    /** Looks at where standard error goes; where the system does not say, at whether there is a console. */
    private static boolean isTerminal() {
        Path standardError = Path.of("/proc/self/fd/2");
        try {
            if (Files.isSymbolicLink(standardError)) {
                String target = Files.readSymbolicLink(standardError).toString();
                return target.startsWith("/dev/pts/") || target.startsWith("/dev/tty");
            }
        } catch (IOException e) {
            return false;
        }
        return System.console() != null;
    }

    /** Shows how far the work has come, a few times a second. */
    void update(long done, long all) {
        first = first < 0 ? done - 1 : first;
        long now = clock.getAsLong();
        if (visible && (now - shown >= INTERVAL || done == all)) {
            shown = now;
            int filled = (int) (BAR_WIDTH * done / Math.max(1, all));
            double rate = (done - first) * NANOS_PER_SECOND / Math.max(1, now - start);
            out.print("\r[" + "#".repeat(filled) + ".".repeat(BAR_WIDTH - filled) + "] " + done + "/" + all + ", "
                    + timeText((all - done) / rate) + " left   ");
            out.flush();
        }
    }

    /** Ends the line. */
    @Override
    public void close() {
        if (visible && first >= 0) {
            out.println();
        }
    }

    /** Returns a time in minutes and seconds, and hours if there are any. */
    static String timeText(double seconds) {
        long whole = Math.round(seconds);
        return whole < 3600
                ? String.format(Locale.ROOT, "%d:%02d", whole / 60, whole % 60)
                : String.format(Locale.ROOT, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
    }
}
