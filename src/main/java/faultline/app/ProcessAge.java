package faultline.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;

/** How long ago this process began. */
final class ProcessAge {

    /** Ticks of a process's clock in a second, the same on every Linux. */
    private static final double CLOCK_TICKS_PER_SECOND = 100;
    /** Where the start stands in the words after the process's name. */
    private static final int START_TIME_FIELD = 19;
    /** How far the time of day of the start may be off, seconds. */
    private static final double START_TIME_TOLERANCE = 2;

    private ProcessAge() {}

    /** Seconds, to a hundredth on Linux; where only the start's time of day is known, as well as that is. */
    static double seconds() {
        double rough = fromStartInstant();
        try {
            double exact = fromProcFiles(
                    Files.readString(Path.of("/proc/self/stat")), Files.readString(Path.of("/proc/uptime")));
            // In some containers the two files count from different starts.
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
     * From when it began and what time it is now, both counted from the machine's start. The process's name may hold
     * blanks and brackets.
     */
    static double fromProcFiles(String stat, String uptime) {
        String[] words = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
        return Double.parseDouble(uptime.split(" ")[0])
                - Long.parseLong(words[START_TIME_FIELD]) / CLOCK_TICKS_PER_SECOND;
    }
}
