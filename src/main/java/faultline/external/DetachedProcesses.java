package faultline.external;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

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
    private static final long LONGEST_SEARCH = TimeUnit.SECONDS.toNanos(5);

    /** What searches in a row that find nothing must count together. */
    private static final int ENOUGH = 9;

    /** What a search counts that finds nothing. */
    private static final int SURE = 3;

    /** What it counts if a process has ended meanwhile, which may have started another one that was not listed yet. */
    private static final int UNSURE = 1;

    private static final int STANDARD_STREAMS = 3;

    /** The index of the size of a process's memory among the fields of its status after its name. */
    private static final int MEMORY_FIELD = 20;

    private static final AtomicLong SEQUENCE = new AtomicLong();

    private final String mark;

    /** The processes that ran before the child was started, also this one. None of them is a descendant. */
    private final Set<ProcessHandle> earlier = listed(ProcessHandle::allProcesses);

    private volatile Set<String> pipes = Set.of();

    /**
     * Creates a mark that no other child has, for a child that is not yet started.
     *
     * @throws IOException if the processes that run cannot be listed
     */
    DetachedProcesses() throws IOException {
        ProcessHandle own = ProcessHandle.current();
        long start = own.info().startInstant().map(Instant::toEpochMilli).orElse(0L);
        mark = own.pid() + "-" + start + "-" + SEQUENCE.incrementAndGet();
    }

    /** Returns the processes of a list that may fail, as without free file descriptors. */
    static Set<ProcessHandle> listed(Supplier<Stream<ProcessHandle>> list) throws IOException {
        try (Stream<ProcessHandle> processes = list.get()) {
            return processes.collect(Collectors.toSet());
        } catch (RuntimeException e) {
            // The JDK throws no subclass.
            throw new IOException(e.getMessage(), e);
        }
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
        Set<ProcessHandle> others = new HashSet<>(earlier);
        int evidence = 0;
        while (evidence < ENOUGH && System.nanoTime() - start < LONGEST_SEARCH) {
            int found = 0;
            boolean isSure = true;
            for (long id : newestFirst()) {
                Optional<ProcessHandle> process = ProcessHandle.of(id).filter(each -> !others.contains(each));
                if (process.isPresent()
                        && belongs(process.get())
                        && process.get().destroyForcibly()) {
                    found++;
                } else if (process.isPresent() && hasEnded(process.get())) {
                    // What it has started is listed by the next search.
                    others.add(process.get());
                    isSure = false;
                }
            }
            evidence = found > 0 ? 0 : evidence + (isSure ? SURE : UNSURE);
        }
    }

    /**
     * Returns the ids of all processes; those that have just started come first, because they may soon start others.
     */
    private static long[] newestFirst() {
        String[] names = new File("/proc").list((folder, name) -> Character.isDigit(name.charAt(0)));
        return names == null
                ? new long[0]
                : Stream.of(names)
                        .mapToLong(Long::parseLong)
                        .map(id -> -id)
                        .sorted()
                        .map(id -> -id)
                        .toArray();
    }

    /**
     * Returns whether a process has ended. On Linux, it is alive until its parent, or the first process of the system,
     * has noticed its end, but it has no memory any more and shows neither its environment nor its streams.
     */
    static boolean hasEnded(ProcessHandle process) {
        try {
            String status = Files.readString(
                    Path.of("/proc", Long.toString(process.pid()), "stat"), StandardCharsets.ISO_8859_1);
            // The name in parentheses may contain blanks.
            String[] fields = status.substring(status.lastIndexOf(')') + 2).split(" ");
            return fields[MEMORY_FIELD].equals("0");
        } catch (IOException notThere) {
            return !process.isAlive();
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
