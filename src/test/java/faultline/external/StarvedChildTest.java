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

    private static final double PATIENCE = 0.5;
    private static final int RIVALS = 3;

    /**
     * Answers each line after it has used a processor for a quarter of a second, which its kernel measures in
     * nanoseconds.
     */
    private static final String WORK = "while read line; do read begun rest < /proc/$$/schedstat; now=$begun; "
            + "while [ $((now - begun)) -lt 250000000 ]; do read now rest < /proc/$$/schedstat; done; "
            + "echo \"$line\"; done";

    private final List<Process> rivals = new ArrayList<>();

    @BeforeEach
    void takeAProcessor() throws IOException {
        for (int i = 0; i < RIVALS; i++) {
            rivals.add(new ProcessBuilder(onThatProcessor("while :; do :; done")).start());
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

    private static String answer(String script) throws Exception {
        try (ChildProcess child = new ChildProcess(onThatProcessor(script), PATIENCE, line -> {})) {
            child.send("line");
            return child.receive(PATIENCE);
        }
    }

    @Test
    void aChildThatComputesForHalfItsTimeAnswersOnABusyProcessor() throws Exception {
        long start = System.nanoTime();
        assertEquals("line", answer(WORK));
        assertTrue((System.nanoTime() - start) / 1e9 > PATIENCE, "the processor was not busy");
    }

    @Test
    void aChildThatSleepsIsSilent() {
        ProtocolException e = assertThrows(ProtocolException.class, () -> answer("sleep 100"));
        assertEquals(
                "X has not answered for 0.5 s then", e.sentence("X", " then").toString());
    }

    @Test
    void aChildThatComputesWithoutEndIsSilent() {
        ProtocolException e = assertThrows(ProtocolException.class, () -> answer("while :; do :; done"));
        assertEquals(
                "X has not answered for 0.5 s then", e.sentence("X", " then").toString());
    }
}
