package faultline.scenario.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.scenario.Scenario;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * Files damaged at random: each is refused in lines of the promised form, or is a good scenario that runs and reads
 * back equal.
 */
class MutatedFilesTest {

    /** How many files are damaged; the system property {@code faultline.fuzz} sets it, for instance to 100000. */
    private static final int FILES = Integer.getInteger("faultline.fuzz", 3000);

    private static final List<String> PIECES = List.of(
            "\"",
            "<",
            ">",
            "/",
            "&",
            "&#0;",
            "]]>",
            "<!--",
            "-->",
            "\0",
            "\n",
            "é",
            "-",
            "e9",
            ".",
            "1e308",
            "NaN",
            "id",
            " x=\"1\"",
            "<robot x=\"1\" y=\"1\"/>",
            "<world/>",
            "<?x?>",
            "xmlns=\"a\"",
            "'",
            " ");

    private final Random random = new Random(7);

    @Test
    void damagedBytesAreRefusedOrRun() {
        int refused = 0;
        for (int i = 0; i < FILES; i++) {
            refused += isRefused(damaged()) ? 1 : 0;
        }
        assertTrue(3 * refused > 2 * FILES && refused < FILES, refused + " were refused");
    }

    @Test
    void linesTakenOutDoubledOrSwappedAreRefusedOrRun() {
        List<String> lines = SampleScenario.PLAIN.lines().toList();
        int refused = 0;
        for (int i = 0; i < 1000; i++) {
            int from = random.nextInt(lines.size());
            String moved = lines.get(random.nextInt(lines.size()));
            String text = lines.stream()
                    .map(line -> line.equals(lines.get(from)) ? moved : line)
                    .collect(Collectors.joining("\n"));
            refused += isRefused(text) ? 1 : 0;
        }
        assertTrue(refused > 500 && refused < 1000, refused + " were refused");
    }

    private String damaged() {
        StringBuilder text = new StringBuilder(SampleScenario.PLAIN);
        int changes = 1 + random.nextInt(3);
        for (int i = 0; i < changes; i++) {
            int at = random.nextInt(text.length() - 5);
            text.replace(
                    at,
                    at + random.nextInt(4),
                    random.nextInt(4) == 0 ? "" : PIECES.get(random.nextInt(PIECES.size())));
        }
        return text.toString();
    }

    private static boolean isRefused(String text) {
        List<String> problems = SampleScenario.problems(text);
        problems.forEach(line -> assertTrue(line.matches("room\\.xml:(\\d+:\\d+:)? [^\\p{Cc}]{5,}"), line));
        assertFalse(problems.stream().anyMatch(line -> line.contains("not as the schema")), problems + "\n" + text);
        if (problems.isEmpty()) {
            assertRuns(text);
        }
        return !problems.isEmpty();
    }

    private static void assertRuns(String text) {
        try {
            Scenario scenario = Scenario.of(ScenarioReader.read("room.xml", text.getBytes(StandardCharsets.UTF_8)));
            assertEquals(scenario, SampleScenario.read(ScenarioWriter.toText(scenario.content(), XmlComments.NONE)));
            try (Simulation simulation = new Simulation(scenario.setup(), ControllerMode.DIRECT)) {
                simulation.tick();
                simulation.tick();
            }
        } catch (ScenarioException e) {
            throw new AssertionError(text, e);
        }
    }
}
