package faultline.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.campaign.plan.SamplePlan;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * Processes that are killed at random moments while they write: a file holds the whole old content or the whole new
 * one. The system property {@code faultline.kills} sets how often each is killed.
 */
class KilledWriterTest {

    private static final byte[] OLD = "old".getBytes(StandardCharsets.UTF_8);
    private static final int CAMPAIGN_RUNS = 60;
    private static final long SAVE_MILLIS = 200;

    @TempDir
    private Path folder;

    /** Saves two scenarios to one file in turn, until it is killed. */
    static final class SaveLoop {

        private SaveLoop() {}

        public static void main(String[] args) throws Exception {
            Path file = Path.of(args[0]);
            scenario("one").save(file);
            System.out.println("saved");
            while (true) {
                scenario("other").save(file);
                scenario("one").save(file);
            }
        }

        private static Scenario scenario(String name) throws Exception {
            Scenario scenario = Scenario.loadShipped("beside-a-wall.xml");
            return new Scenario(name, "", false, scenario.setup(), scenario.expectation());
        }
    }

    private static Process start(String... arguments) throws IOException {
        return JavaProcess.start("faultline.app.Main", List.of(arguments));
    }

    /** Waits for a process that is not killed, and returns its duration, in milliseconds. */
    private static long finish(Process process) throws InterruptedException {
        long start = System.nanoTime();
        assertTrue(process.waitFor(300, TimeUnit.SECONDS));
        assertTrue(process.exitValue() <= 1, "ended with " + process.exitValue());
        return TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - start);
    }

    /** Lets what was left behind look older than it is. */
    private void age() throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Files.setLastModifiedTime(file, FileTime.fromMillis(1));
            }
        }
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile)
                    .map(file -> file.getFileName().toString())
                    .sorted()
                    .toList();
        }
    }

    private void assertOldOrNew(byte[] complete, Path file) throws IOException {
        byte[] found = Files.readAllBytes(file);
        assertTrue(
                Arrays.equals(found, OLD) || Arrays.equals(found, complete),
                () -> file + ": " + found.length + " bytes");
    }

    private Process run() throws IOException {
        return start(
                "run",
                "scenarios/beside-a-wall.xml",
                "--until",
                "60",
                "--trace",
                folder.resolve("trace.csv").toString(),
                "--image",
                folder.resolve("end.png").toString(),
                "--journal",
                folder.resolve("journal.xml").toString());
    }

    @Test
    void aKilledRunLeavesEachOutputWholeAndTheNextOneCleansUp() throws Exception {
        List<String> outputs = List.of("end.png", "journal.xml", "trace.csv");
        long millis = finish(run());
        List<byte[]> complete = new ArrayList<>();
        for (String output : outputs) {
            complete.add(Files.readAllBytes(folder.resolve(output)));
        }
        int killed = 0;
        for (int i = 0; i < JavaProcess.KILLS; i++) {
            for (String output : outputs) {
                Files.write(folder.resolve(output), OLD);
            }
            killed += JavaProcess.killWithin(millis, run()) ? 1 : 0;
            for (int k = 0; k < outputs.size(); k++) {
                assertOldOrNew(complete.get(k), folder.resolve(outputs.get(k)));
            }
        }
        System.out.println("run: killed " + killed + " times, within " + millis + " ms");
        age();
        finish(run());
        assertArrayEquals(complete.get(2), Files.readAllBytes(folder.resolve("trace.csv")));
        assertEquals(outputs, names());
    }

    /** The signal arrives when the first output is in place, if the others are not in place by then. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aRunThatIsEndedWhileItsOutputsTakeTheirPlacesLeavesAllNew() throws Exception {
        List<String> outputs = List.of("end.png", "journal.xml", "trace.csv");
        for (int i = 0; i < JavaProcess.KILLS; i++) {
            for (String output : outputs) {
                Files.write(folder.resolve(output), OLD);
            }
            Process process = run();
            while (process.isAlive() && Files.size(folder.resolve("trace.csv")) == OLD.length) {
                Thread.onSpinWait();
            }
            process.destroy();
            assertTrue(process.waitFor(60, TimeUnit.SECONDS));
            for (String output : outputs) {
                assertTrue(Files.size(folder.resolve(output)) > OLD.length, output);
            }
            assertEquals(outputs, names());
        }
    }

    @Test
    void aKilledSaveLeavesTheOldScenarioOrTheNewOne() throws Exception {
        Path file = folder.resolve("saved.xml");
        for (int i = 0; i < JavaProcess.KILLS; i++) {
            Process process = JavaProcess.startAndAwaitOutput(SaveLoop.class.getName(), List.of(file.toString()));
            assertTrue(JavaProcess.killWithin(SAVE_MILLIS, process));
            assertTrue(List.of("one", "other").contains(Scenario.load(file).name()));
        }
        age();
        finish(start("run", "scenarios/beside-a-wall.xml", "--until", "1", "--journal", file.toString()));
        assertEquals(List.of("saved.xml"), names());
    }

    private Process campaign(String out) throws IOException {
        return start(
                "campaign",
                folder.resolve("plan.xml").toString(),
                "--out",
                folder.resolve(out).toString(),
                "--resume");
    }

    @Test
    void aCampaignKilledAtRandomMomentsGivesTheSameTable() throws Exception {
        Files.writeString(folder.resolve("room.xml"), SamplePlan.ROOM);
        Files.writeString(
                folder.resolve("plan.xml"),
                SamplePlan.text(
                        "", "<worlds><scenario file=\"room.xml\"/></worlds><seeds count=\"" + CAMPAIGN_RUNS + "\"/>"));
        long millis = finish(campaign("whole"));
        byte[] complete = Files.readAllBytes(folder.resolve("whole/runs.csv"));
        Path table = folder.resolve("killed/runs.csv");
        int killed = 0;
        int completed = 0;
        while (killed < JavaProcess.KILLS) {
            if (JavaProcess.killWithin(millis, campaign("killed"))) {
                killed++;
            } else {
                completed++;
                assertArrayEquals(complete, Files.readAllBytes(table));
                // The next campaign begins in an empty folder.
                deleteFolder(folder.resolve("killed"));
            }
        }
        System.out.println("campaign: killed " + killed + " times, completed " + completed + " times in between");
        age();
        finish(campaign("killed"));
        assertArrayEquals(complete, Files.readAllBytes(table));
        assertEquals(
                List.of(),
                names().stream().filter(name -> name.endsWith(".tmp")).toList());
    }

    private static void deleteFolder(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
