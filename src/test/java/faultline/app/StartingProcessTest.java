package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.io.BufferedReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A simulator does not outlive the client that waits for its answer. */
@Timeout(120)
class StartingProcessTest {

    @TempDir
    private Path folder;

    /** Starts a simulator, asks for a step of hours, prints the id of the simulator's process, and waits. */
    static final class Client {

        private Client() {}

        public static void main(String[] arguments) throws Exception {
            Process simulator = JavaProcess.builder("faultline.app.Main", List.of("serve", arguments[0]))
                    .start();
            BufferedReader answers = simulator.inputReader(StandardCharsets.UTF_8);
            assertTrue(answers.readLine().startsWith("{\"type\":\"hello\""));
            OutputStream requests = simulator.getOutputStream();
            requests.write("{\"type\":\"drive\",\"left_v\":0,\"right_v\":0,\"ticks\":1000000000}\n"
                    .getBytes(StandardCharsets.UTF_8));
            requests.flush();
            System.out.println(simulator.pid());
            answers.readLine();
        }
    }

    @Test
    void aStepEndsWithTheClientThatIsKilled() throws Exception {
        Path room = Files.writeString(
                folder.resolve("room.xml"),
                "<scenario xmlns='urn:faultline:scenario:1' duration='10000000'><world width='3' height='3'/>"
                        + "<robot x='1.2' y='1'/></scenario>");
        Process client = JavaProcess.builder(Client.class.getName(), List.of(room.toString()))
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        String pid = client.inputReader(StandardCharsets.UTF_8).readLine();
        ProcessHandle simulator = ProcessHandle.of(Long.parseLong(pid)).orElseThrow();
        try {
            assertFalse(simulator.onExit().isDone());
            client.destroyForcibly().waitFor();
            assertEquals(simulator, simulator.onExit().get(60, TimeUnit.SECONDS));
        } finally {
            simulator.destroyForcibly();
        }
    }
}
