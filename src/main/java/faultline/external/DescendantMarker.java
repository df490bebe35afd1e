package faultline.external;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicLong;

/**
 * An environment variable that a child passes on to the processes that it starts. On Linux it identifies descendants
 * that are no longer below the child because the process that started them has ended.
 *
 * @param value the value of the variable, different for each child
 */
record DescendantMarker(String value) {

    /** The name of the variable. */
    static final String VARIABLE = "FAULTLINE_CHILD";

    private static final AtomicLong SEQUENCE = new AtomicLong();

    static DescendantMarker create() {
        ProcessHandle own = ProcessHandle.current();
        long start = own.info().startInstant().map(Instant::toEpochMilli).orElse(0L);
        return new DescendantMarker(own.pid() + "-" + start + "-" + SEQUENCE.incrementAndGet());
    }

    /** Ends every process that has the mark. */
    void killAll() {
        String entry = VARIABLE + "=" + value + "\0";
        ProcessHandle.allProcesses()
                .filter(process -> isMarked(process, entry))
                .forEach(ProcessHandle::destroyForcibly);
    }

    private static boolean isMarked(ProcessHandle process, String entry) {
        Path environment = Path.of("/proc", Long.toString(process.pid()), "environ");
        try {
            return Files.isReadable(environment)
                    && new String(Files.readAllBytes(environment), StandardCharsets.ISO_8859_1).contains(entry);
        } catch (IOException ended) {
            return false;
        }
    }
}
