package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.metrics.Expectation;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every file in the folder scenarios and below it, run against what it expects. */
public class ShippedScenariosTest {

    private static final Path FOLDER = Path.of("scenarios");

    public static List<Path> files() throws IOException {
        try (Stream<Path> files = Files.walk(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".xml"))
                    .filter(file -> !file.startsWith(FOLDER.resolve("campaigns")))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("files")
    void everyShippedScenarioHoldsWhatItExpects(Path file) throws ScenarioException {
        ScenarioRun run = Scenario.load(file).run();
        assertEquals(List.of(), run.unmetExpectations());
    }

    @ParameterizedTest
    @MethodSource("files")
    void everyShippedScenarioHasAnExpectationAndADescription(Path file) throws ScenarioException {
        Scenario scenario = Scenario.load(file);
        assertTrue(!scenario.expectation().equals(Expectation.NONE), "expects nothing");
        assertTrue(!scenario.name().isEmpty() && !scenario.description().isEmpty(), "has no description");
    }

    @ParameterizedTest
    @MethodSource("files")
    void everyShippedScenarioIsInTheProgramAsWell(Path file) throws ScenarioException {
        assertEquals(
                Scenario.load(file),
                Scenario.loadShipped(FOLDER.relativize(file).toString()));
    }

    @Test
    void thereAreAtLeastTen() throws IOException {
        assertTrue(files().size() >= 10, files().toString());
    }
}
