package faultline.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Processes that are killed while they write: a file holds the whole old content or the whole new one. The system
 * property {@code faultline.kills} sets how often each is killed. {@link CampaignProcessTest} does the same to
 * campaigns.
 */
class KilledWriterTest {

    private static final int KILLS = Integer.getInteger("faultline.kills", 4);
    private static final int MAX_DELAY_MILLIS = 900;

    @TempDir
    private Path folder;

    private final SplittableRandom random = new SplittableRandom(99);

    /** Saves two scenarios to one file in turn, until it is killed. */
    static final class SaveLoop {

        private SaveLoop() {}

        public static void main(String[] args) throws Exception {
            while (true) {
                scenario("one").save(Path.of(args[0]));
                scenario("other").save(Path.of(args[0]));
            }
        }

        private static Scenario scenario(String name) throws Exception {
            Scenario scenario = Scenario.loadShipped("beside-a-wall.xml");
            return new Scenario(name, "", false, scenario.setup(), scenario.expectation());
        }
    }

    private static Process start(String mainClass, List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                location(CommandLine.class) + System.getProperty("path.separator") + location(KilledWriterTest.class),
                mainClass));
        command.addAll(arguments);
        return new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    private static String location(Class<?> type) {
        return Path.of(java.net.URI.create(
                        type.getProtectionDomain().getCodeSource().getLocation().toString()))
                .toString();
    }

    private void kill(Process process) throws InterruptedException {
        Thread.sleep(random.nextInt(MAX_DELAY_MILLIS));
        process.destroyForcibly().waitFor();
    }

    /** Lets what was left behind look older than it is. */
    private void age() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.setLastModifiedTime(file, FileTime.fromMillis(1));
            }
        }
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private Process run() throws IOException {
        return start(
                "faultline.app.Main",
                List.of(
                        "run",
                        "scenarios/beside-a-wall.xml",
                        "--until",
                        "300",
                        "--trace",
                        folder.resolve("trace.csv").toString(),
                        "--journal",
                        folder.resolve("journal.xml").toString()));
    }

    @Test
    void aKilledRunLeavesEachOutputWholeAndTheNextOneCleansUp() throws Exception {
        byte[] old = "old".getBytes(StandardCharsets.UTF_8);
        Process whole = run();
        assertTrue(whole.waitFor(120, TimeUnit.SECONDS) && whole.exitValue() <= 1);
        byte[] complete = Files.readAllBytes(folder.resolve("trace.csv"));
        for (int i = 0; i < KILLS; i++) {
            Files.write(folder.resolve("trace.csv"), old);
            kill(run());
            byte[] found = Files.readAllBytes(folder.resolve("trace.csv"));
            assertTrue(Arrays.equals(found, old) || Arrays.equals(found, complete), found.length + " bytes");
        }
        age();
        assertTrue(run().waitFor(120, TimeUnit.SECONDS));
        assertArrayEquals(complete, Files.readAllBytes(folder.resolve("trace.csv")));
        assertEquals(List.of("journal.xml", "trace.csv"), names());
    }

    @Test
    void aKilledSaveLeavesTheOldScenarioOrTheNewOne() throws Exception {
        Path file = folder.resolve("saved.xml");
        SaveLoop.scenario("one").save(file);
        for (int i = 0; i < KILLS; i++) {
            kill(start(SaveLoop.class.getName(), List.of(file.toString())));
            assertTrue(List.of("one", "other").contains(Scenario.load(file).name()));
        }
    }
}
