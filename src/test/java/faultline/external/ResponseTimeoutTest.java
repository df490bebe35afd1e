package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The delays of a process whose threads end while they are read. */
class ResponseTimeoutTest {

    private static final int PAIRS = 20;

    @TempDir
    Path tasks;

    /** The order in which a folder is listed is the file system's, so threads that have ended come between others. */
    @Test
    void theThreadsThatStillRunCountAmongThoseThatHaveEnded() throws IOException {
        Map<Path, Long> expected = new HashMap<>();
        for (long i = 0; i < PAIRS; i++) {
            Files.createDirectory(tasks.resolve("ended" + i));
            Path running = Files.createDirectory(tasks.resolve("running" + i));
            Files.writeString(running.resolve("schedstat"), "5000 " + i + " 12\n");
            expected.put(running, i);
        }
        Map<Path, Long> delays = new HashMap<>();
        ResponseTimeout.addDelays(tasks, delays);
        assertEquals(expected, delays);
    }

    @Test
    void aProcessThatHasEndedDelaysNothing() {
        Map<Path, Long> delays = new HashMap<>();
        ResponseTimeout.addDelays(tasks.resolve("none"), delays);
        assertEquals(Map.of(), delays);
    }
}
