package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.gui.text.Translations;
import faultline.scenario.xml.FileMutator;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SchemaCheck;
import faultline.scenario.xml.XmlComments;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Files damaged at random: each is refused in lines of the promised form, or is a good scenario that the schema allows,
 * runs, and reads back equal.
 */
class MutatedFilesTest {

    /** How many files are damaged; the system property {@code faultline.fuzz} sets it, for instance to 100000. */
    private static final int FILES = Integer.getInteger("faultline.fuzz", 3000);

    private static final int TICKS = 5;
    private static final Duration MAX_TIME = Duration.ofSeconds(10);

    private static final SchemaCheck SCHEMA = SchemaCheck.ofScenarios();

    private final FileMutator mutator = new FileMutator();

    @Test
    void damagedFilesAreRefusedOrRun() throws IOException {
        List<String> originals = originals();
        int refused = 0;
        for (int i = 0; i < FILES; i++) {
            String original = i % 2 == 0 ? SampleScenario.PLAIN : mutator.pick(originals);
            refused += isRefused(mutator.damaged(original)) ? 1 : 0;
        }
        assertTrue(2 * refused > FILES && refused < FILES, refused + " were refused");
    }

    /** Returns the shipped scenarios. */
    private static List<String> originals() throws IOException {
        List<String> texts = new ArrayList<>();
        for (Path folder : List.of(Path.of("scenarios"), Path.of("scenarios/studies"))) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
                    texts.add(Files.readString(file));
                }
            }
        }
        return texts;
    }

    @Test
    void linesTakenOutDoubledOrSwappedAreRefusedOrRun() {
        List<String> lines = SampleScenario.PLAIN.lines().toList();
        int refused = 0;
        for (int i = 0; i < 1000; i++) {
            String from = mutator.pick(lines);
            String moved = mutator.pick(lines);
            String text =
                    lines.stream().map(line -> line.equals(from) ? moved : line).collect(Collectors.joining("\n"));
            refused += isRefused(text.getBytes(StandardCharsets.UTF_8)) ? 1 : 0;
        }
        assertTrue(refused > 500 && refused < 1000, refused + " were refused");
    }

    private static boolean isRefused(byte[] file) {
        return assertTimeout(MAX_TIME, () -> isRefusedInTime(file), () -> text(file));
    }

    private static boolean isRefusedInTime(byte[] file) {
        try {
            Scenario scenario = SampleScenario.read(file);
            SCHEMA.assertValid(file);
            assertRuns(file, scenario);
            return false;
        } catch (ScenarioException e) {
            e.problems().forEach(problem -> Translations.assertTranslated(problem.message()));
            for (Problem problem : e.problems()) {
                String line = problem.toString();
                assertTrue(line.matches("room\\.xml:(\\d+:\\d+:)? [^\\p{Cc}]{5,}"), line);
            }
            return true;
        } catch (RuntimeException | Error e) {
            throw new AssertionError(text(file), e);
        }
    }

    private static String text(byte[] file) {
        return new String(file, StandardCharsets.UTF_8);
    }

    private static void assertRuns(byte[] file, Scenario scenario) {
        try {
            byte[] written = ScenarioWriter.toText(scenario, XmlComments.NONE).getBytes(StandardCharsets.UTF_8);
            assertEquals(scenario, SampleScenario.read(written));
            try (Simulation simulation = new Simulation(scenario.setup(), ControllerMode.DIRECT)) {
                for (int i = 0; i < TICKS; i++) {
                    simulation.tick();
                }
            }
        } catch (ScenarioException e) {
            throw new AssertionError(text(file), e);
        }
    }
}
