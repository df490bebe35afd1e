package faultline.external;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The descendants of a child that are no longer below it because the process that started them has ended. On Linux they
 * are identified by an environment variable that the child passes on to the processes that it starts, and by the pipes
 * of its standard streams, because a process can lose its environment: {@code env -i} clears it, and a Perl program
 * that changes its name overwrites it.
 */
final class DetachedProcesses {

    /** The name of the environment variable. */
    static final String VARIABLE = "FAULTLINE_CHILD";

    /** The time for which processes are searched again because new ones were found, nanoseconds. */
    private static final long LONGEST_SEARCH = TimeUnit.SECONDS.toNanos(2);

    /** What searches in a row that find nothing must count together. */
    private static final int ENOUGH = 9;

    /** What a search counts that finds nothing. */
    private static final int SURE = 3;

    /** What it counts if a process has ended meanwhile, which may have started another one that was not listed yet. */
    private static final int UNSURE = 1;

    private static final int STANDARD_STREAMS = 3;
    private static final AtomicLong SEQUENCE = new AtomicLong();

    private final String mark;

    /** The processes that ran before the child was started, also this one. None of them is a descendant. */
    private final Set<ProcessHandle> earlier = ProcessHandle.allProcesses().collect(Collectors.toSet());

    private volatile Set<String> pipes = Set.of();

    /** Creates a mark that no other child has, for a child that is not yet started. */
    DetachedProcesses() {
        ProcessHandle own = ProcessHandle.current();
        long start = own.info().startInstant().map(Instant::toEpochMilli).orElse(0L);
        mark = own.pid() + "-" + start + "-" + SEQUENCE.incrementAndGet();
    }

    /** {@return the value of the environment variable, different for each child} */
    String mark() {
        return mark;
    }

    /** Notes the pipes of a child that was just started with the mark. */
    void follow(Process child) {
        pipes = IntStream.range(0, STANDARD_STREAMS)
                .mapToObj(stream -> pipe(child.pid(), stream))
                .flatMap(Optional::stream)
                .collect(Collectors.toSet());
    }

    /** Returns the pipe that is a standard stream of a process. */
    private static Optional<String> pipe(long pid, int stream) {
        try {
            return Optional.of(Files.readSymbolicLink(Path.of("/proc", pid + "/fd/" + stream)))
                    .map(Path::toString)
                    .filter(target -> target.startsWith("pipe:"));
        } catch (IOException notThere) {
            return Optional.empty();
        }
    }

    /** Ends the processes, and those that they start meanwhile. */
    void killAll() {
        long start = System.nanoTime();
        int evidence = 0;
        while (evidence < ENOUGH && System.nanoTime() - start < LONGEST_SEARCH) {
            List<ProcessHandle> later = ProcessHandle.allProcesses()
                    .filter(process -> !earlier.contains(process))
                    .toList();
            long found = later.stream()
                    .filter(process -> belongs(process) && process.destroyForcibly())
                    .count();
            boolean ended = !later.stream().allMatch(ProcessHandle::isAlive);
            evidence = found > 0 ? 0 : evidence + (ended ? UNSURE : SURE);
        }
    }

    private boolean belongs(ProcessHandle process) {
        return isMarked(process) || hasPipe(process);
    }

    private boolean isMarked(ProcessHandle process) {
        Path environment = Path.of("/proc", Long.toString(process.pid()), "environ");
        try {
            return Files.isReadable(environment)
                    && new String(Files.readAllBytes(environment), StandardCharsets.ISO_8859_1)
                            .contains(VARIABLE + "=" + mark + "\0");
        } catch (IOException ended) {
            return false;
        }
    }

    /** A process that the program is just starting may still have the other ends. */
    private boolean hasPipe(ProcessHandle process) {
        return IntStream.range(0, STANDARD_STREAMS)
                        .mapToObj(stream -> pipe(process.pid(), stream))
                        .flatMap(Optional::stream)
                        .anyMatch(pipes::contains)
                && !process.parent().equals(Optional.of(ProcessHandle.current()));
    }
}
