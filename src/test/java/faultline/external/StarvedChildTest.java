package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/**
 * Tests that time without a processor does not count as time of a child, but time in which it sleeps or computes does.
 */
@Timeout(120)
@EnabledOnOs(value = OS.LINUX, disabledReason = "measures what a thread waits for a processor")
class StarvedChildTest {

    /**
     * The time limit, seconds. The kernel adds a wait for a processor only when it ends, so a wait of half this limit
     * must be rare.
     */
    private static final double PATIENCE = 1;

    private static final int RIVALS = 3;

    /** Answers each line after it has used a processor for 0.4 s, which its kernel measures in nanoseconds. */
    private static final String WORK = "while read line; do read begun rest < /proc/$$/schedstat; now=$begun; "
            + "while [ $((now - begun)) -lt 400000000 ]; do read now rest < /proc/$$/schedstat; done; "
            + "echo \"$line\"; done";

    private final List<Process> rivals = new ArrayList<>();

    @BeforeEach
    void takeAProcessor() throws IOException {
        for (int i = 0; i < RIVALS; i++) {
            Process rival = new ProcessBuilder(onThatProcessor("echo begins; while :; do :; done")).start();
            rivals.add(rival);
            assertEquals('b', rival.getInputStream().read());
        }
    }

    @AfterEach
    void releaseIt() {
        rivals.forEach(Process::destroyForcibly);
    }

    /** Returns a command that runs on the first processor that this process may use, and on no other. */
    private static List<String> onThatProcessor(String script) throws IOException {
        String allowed = Files.readAllLines(Path.of("/proc/self/status")).stream()
                .filter(line -> line.startsWith("Cpus_allowed_list:"))
                .findFirst()
                .orElseThrow();
        return List.of("taskset", "-c", allowed.replaceAll("\\D*(\\d+).*", "$1"), "sh", "-c", script);
    }

    /** Returns the answer of a child to a line that it gets when it runs; its start has no limit. */
    private static String answer(String script) throws Exception {
        List<String> command = onThatProcessor("echo begins; " + script);
        try (ChildProcess child = new ChildProcess(command, PATIENCE, line -> {})) {
            assertEquals("begins", child.receive(Double.POSITIVE_INFINITY));
            child.send("line");
            return child.receive(PATIENCE);
        }
    }

    @Test
    void aChildThatComputesForLessThanItsTimeAnswersOnABusyProcessor() throws Exception {
        long start = System.nanoTime();
        assertEquals("line", answer(WORK));
        assertTrue((System.nanoTime() - start) / 1e9 > PATIENCE, "the processor was not busy");
    }

    @Test
    void aChildThatSleepsIsSilent() {
        ProtocolException e = assertThrows(ProtocolException.class, () -> answer("sleep 100"));
        assertEquals(
                "X has not answered for 1.0 s then", e.sentence("X", " then").toString());
    }

    @Test
    void aChildThatComputesWithoutEndIsSilent() {
        ProtocolException e = assertThrows(ProtocolException.class, () -> answer("while :; do :; done"));
        assertEquals(
                "X has not answered for 1.0 s then", e.sentence("X", " then").toString());
    }
}
