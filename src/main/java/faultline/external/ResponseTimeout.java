package faultline.external;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;

/**
 * The time spent waiting for a child, with a limit. Time in which the child was ready to run while other programs used
 * the processors does not count. Linux measures this time for each thread; elsewhere all time counts.
 */
final class ResponseTimeout {

    private static final double NANOS_PER_SECOND = 1e9;

    /**
     * The share of the limit during which all time counts, so that measuring the child does not delay quick answers.
     */
    private static final double COUNTED_IN_FULL = 0.1;

    private final ProcessHandle child;
    /** The limit, nanoseconds; the following two are nanoseconds, too. */
    private final double limit;

    private double waited;
    private double waitedAtMark;
    private long mark;
    /** The run-queue delay of each thread of the child's family at the mark, or null before the first mark. */
    private Map<Path, Long> delaysAtMark;

    /**
     * Begins a wait.
     *
     * @param child the child that must answer; its descendants are included
     * @param seconds the limit; infinity for no limit
     */
    ResponseTimeout(ProcessHandle child, double seconds) {
        this.child = child;
        this.limit = seconds * NANOS_PER_SECOND;
    }

    /** Counts a part of the time waited, nanoseconds. */
    void count(long nanos) {
        waited += nanos;
        if (delaysAtMark == null && waited > COUNTED_IN_FULL * limit) {
            setMark(delays());
        } else if (waited > limit) {
            Map<Path, Long> delays = delays();
            waited -= (waited - waitedAtMark) * starvedShare(delays);
            setMark(delays);
        }
    }

    /** Returns the time that counts, nanoseconds. */
    double waited() {
        return waited;
    }

    boolean isExhausted() {
        return waited > limit;
    }

    private void setMark(Map<Path, Long> delays) {
        waitedAtMark = waited;
        mark = System.nanoTime();
        delaysAtMark = delays;
    }

    /** Returns the share of the time since the mark in which the thread that was delayed most had no processor. */
    private double starvedShare(Map<Path, Long> delays) {
        long longest = 0;
        for (Map.Entry<Path, Long> now : delays.entrySet()) {
            Long before = delaysAtMark.get(now.getKey());
            longest = Math.max(longest, before == null ? 0 : now.getValue() - before);
        }
        return Math.min(1, (double) longest / Math.max(1, System.nanoTime() - mark));
    }

    private Map<Path, Long> delays() {
        Map<Path, Long> delays = new HashMap<>();
        Stream.concat(Stream.of(child), ChildProcess.descendants(child).stream())
                .map(process -> Path.of("/proc", Long.toString(process.pid()), "task"))
                .forEach(threads -> addDelays(threads, delays));
        return delays;
    }

    /**
     * Adds the run-queue delay of each thread that is still alive.
     *
     * @param threads the folder of a process with one folder for each of its threads
     */
    static void addDelays(Path threads, Map<Path, Long> delays) {
        try (DirectoryStream<Path> each = Files.newDirectoryStream(threads)) {
            for (Path thread : each) {
                addDelay(thread, delays);
            }
        } catch (IOException | DirectoryIteratorException ended) {
            // The process has ended, or the system does not measure the delay: there is no delay.
        }
    }

    private static void addDelay(Path thread, Map<Path, Long> delays) {
        try {
            // The time on a processor, the time ready to run without one, nanoseconds, and the number of turns.
            String[] fields = Files.readString(thread.resolve("schedstat")).split(" ");
            delays.put(thread, Long.parseLong(fields[1]));
        } catch (IOException ended) {
            // A thread that has ended since the folder was listed has no delay; the others still count.
        }
    }
}
