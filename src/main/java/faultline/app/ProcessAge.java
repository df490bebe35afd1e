package faultline.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;

/** The time since the start of this process. */
final class ProcessAge {

    /** Clock ticks per second in {@code /proc}, the same on every Linux. */
    private static final double CLOCK_TICKS_PER_SECOND = 100;
    /** Index of the start time among the fields after the process's name. */
    private static final int START_TIME_FIELD = 19;
    /** Largest accepted difference from the start time reported by {@link ProcessHandle}, seconds. */
    private static final double START_TIME_TOLERANCE = 2;

    private ProcessAge() {}

    /** Returns the age in seconds, accurate to 0.01 s on Linux, elsewhere as accurate as {@link ProcessHandle}. */
    static double seconds() {
        double rough = fromStartInstant();
        try {
            double exact = fromProcFiles(
                    Files.readString(Path.of("/proc/self/stat")), Files.readString(Path.of("/proc/uptime")));
            // In some containers the two files count from different starting points.
            return Math.abs(exact - rough) < START_TIME_TOLERANCE ? exact : rough;
        } catch (IOException elsewhere) {
            return rough;
        }
    }

    private static double fromStartInstant() {
        Instant start = ProcessHandle.current().info().startInstant().orElseGet(Instant::now);
        return Duration.between(start, Instant.now()).toNanos() / 1e9;
    }

    /**
     * Computes the age from the two files' contents, both of which count from system boot. The process name may contain
     * blanks and parentheses.
     */
    static double fromProcFiles(String stat, String uptime) {
        String[] words = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
        return Double.parseDouble(uptime.split(" ")[0])
                - Long.parseLong(words[START_TIME_FIELD]) / CLOCK_TICKS_PER_SECOND;
    }
}
