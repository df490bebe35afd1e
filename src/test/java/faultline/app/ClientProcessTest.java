package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A simulator does not outlive the client that waits for its answer, and answers one that is there. */
@Timeout(120)
class ClientProcessTest {

    @TempDir
    private Path folder;

    /**
     * Starts a simulator by a command, asks for a step of hours, prints the id of the process that it has started, and
     * waits.
     */
    static final class Client {

        private Client() {}

        public static void main(String[] command) throws Exception {
            Process started = new ProcessBuilder(command).start();
            BufferedReader answers = started.inputReader(StandardCharsets.UTF_8);
            assertTrue(answers.readLine().startsWith("{\"type\":\"hello\""));
            OutputStream requests = started.getOutputStream();
            requests.write(drive(1_000_000_000).getBytes(StandardCharsets.UTF_8));
            requests.flush();
            System.out.println(started.pid());
            answers.readLine();
        }
    }

    private static String drive(int ticks) {
        return "{\"type\":\"drive\",\"left_v\":0,\"right_v\":0,\"ticks\":" + ticks + "}\n";
    }

    /** Returns the words that run a simulator, after those of a command that is between it and the client. */
    private List<String> serve(String... between) throws IOException {
        Path room = Files.writeString(
                folder.resolve("room.xml"),
                "<scenario xmlns='urn:faultline:scenario:1' duration='10000000'><world width='3' height='3'/>"
                        + "<robot x='1.2' y='1'/></scenario>");
        List<String> command = new ArrayList<>(List.of(between));
        command.addAll(JavaProcess.program());
        command.addAll(List.of("serve", room.toString()));
        return command;
    }

    private static ProcessHandle startClient(List<String> command, Process[] client) throws IOException {
        client[0] = JavaProcess.builder(Client.class.getName(), command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        String pid = client[0].inputReader(StandardCharsets.UTF_8).readLine();
        return ProcessHandle.of(Long.parseLong(pid)).orElseThrow();
    }

    private static void assertEndsWithTheClient(ProcessHandle simulator, Process client) throws Exception {
        try {
            assertFalse(simulator.onExit().isDone());
            client.destroyForcibly().waitFor();
            assertEquals(simulator, simulator.onExit().get(30, TimeUnit.SECONDS));
        } finally {
            simulator.destroyForcibly();
        }
    }

    @Test
    void aStepEndsWithTheClientThatIsKilled() throws Exception {
        Process[] client = new Process[1];
        assertEndsWithTheClient(startClient(serve(), client), client[0]);
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "elsewhere the readers of the answers are not known")
    void aStepEndsWithTheClientThatIsKilledBehindAShell() throws Exception {
        Process[] client = new Process[1];
        ProcessHandle shell = startClient(serve("sh", "-c", "\"$@\"; true", "sh"), client);
        ProcessHandle simulator = shell.children().findFirst().orElseThrow();
        // The first question is asked half a second after the start of the step.
        assertFalse(
                simulator.onExit().completeOnTimeout(null, 3, TimeUnit.SECONDS).get() != null);
        assertEndsWithTheClient(simulator, client[0]);
    }

    /** In a container, nobody may wait for the end of a process. */
    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "elsewhere the readers of the answers are not known")
    void aStepEndsWithTheClientThatIsAZombie() throws Exception {
        List<String> command = new ArrayList<>(List.of("sh", "-c", "\"$@\" & exec sleep 100", "sh"));
        command.addAll(JavaProcess.builder(Client.class.getName(), serve()).command());
        Process sleep = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        try {
            String pid = sleep.inputReader(StandardCharsets.UTF_8).readLine();
            ProcessHandle simulator = ProcessHandle.of(Long.parseLong(pid)).orElseThrow();
            assertFalse(simulator
                            .onExit()
                            .completeOnTimeout(null, 3, TimeUnit.SECONDS)
                            .get()
                    != null);
            assertTrue(simulator.parent().orElseThrow().destroyForcibly());
            assertEquals(simulator, simulator.onExit().get(30, TimeUnit.SECONDS));
        } finally {
            sleep.destroyForcibly();
        }
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "elsewhere the readers of the answers are not known")
    void aReaderGetsTheAnswerAlsoIfTheShellEndsThatStartedTheSimulator() throws Exception {
        Path requests = Files.writeString(folder.resolve("requests"), drive(15_000_000));
        Process shell = new ProcessBuilder(serve("sh", "-c", "(\"$@\" < " + requests + " & read end) | cat", "sh"))
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        BufferedReader answers = shell.inputReader(StandardCharsets.UTF_8);
        assertTrue(answers.readLine().startsWith("{\"type\":\"hello\""));
        shell.getOutputStream().close();
        assertEquals(1, answers.lines().filter(line -> line.contains("observe")).count());
    }
}
