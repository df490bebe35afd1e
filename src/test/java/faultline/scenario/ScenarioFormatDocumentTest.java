package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the document about the format agrees with the format. */
class ScenarioFormatDocumentTest {

    private static final Path DOCUMENT = Path.of("docs/scenario-format.md");

    private static List<String> all(String pattern, String text) {
        return Pattern.compile(pattern, Pattern.DOTALL)
                .matcher(text)
                .results()
                .map((MatchResult found) -> found.group(1))
                .distinct()
                .toList();
    }

    @Test
    void everyElementAttributeAndWordOfTheSchemaIsExplained() throws IOException {
        String document = Files.readString(DOCUMENT);
        String schema = Files.readString(Path.of("docs/scenario-1.xsd"));
        List<String> names = all("(?:element|attribute|enumeration) (?:name|value)=\"([^\"]+)\"", schema);
        assertTrue(names.size() > 60, names.toString());
        assertEquals(
                List.of(),
                names.stream()
                        .filter(name ->
                                !document.contains("`" + name + "`") && !document.contains("### " + name + "\n"))
                        .toList());
    }

    @Test
    void theExamplesAreGoodScenarios() throws Exception {
        List<String> examples = all("```xml\n(.*?)```", Files.readString(DOCUMENT));
        assertEquals(2, examples.size());
        for (String example : examples) {
            assertEquals(List.of(), SampleScenario.problems(example));
        }
    }

    /** Both pages list the kinds of fault of a sensor, one with their limits, the other with their models. */
    @ParameterizedTest
    @ValueSource(strings = {"docs/scenario-format.md", "docs/faults.md"})
    void everyKindOfFaultHasItsDefault(Path page) throws IOException {
        String text = Files.readString(page);
        String table = text.substring(text.indexOf("`value` | default |"));
        for (FaultKind kind : FaultKind.values()) {
            String row = table.lines()
                    .filter(line -> line.startsWith("| `" + kind.fileName() + "` | "))
                    .findFirst()
                    .orElseThrow(() -> new AssertionError(page + " has no row of " + kind));
            String said = row.split("\\|")[3].replaceFirst(";.*", "").strip();
            assertEquals(
                    kind.takesValue() ? kind.defaultValue() : Double.NaN,
                    said.isEmpty() ? Double.NaN : Double.parseDouble(said),
                    row);
        }
    }

    @Test
    void theStandardSensorsAreWhereThePageSays() throws IOException {
        String text = Files.readString(DOCUMENT);
        for (SensorSpec sensor : RobotSpec.DEFAULT.sensors()) {
            String row =
                    all("(\\| `" + sensor.id() + "` \\| [^\n]* \\|)\n", text).get(0);
            String[] cells = row.split(" \\| ");
            assertEquals(
                    sensor.mountPosition().x() + ", " + sensor.mountPosition().y(), decimals(cells[3]), row);
            double bearing = Double.parseDouble(cells[4].replace(" |", ""));
            assertEquals(bearing, StrictMath.toDegrees(sensor.bearing()), 1e-9, row);
        }
    }

    /** Returns a list of numbers as the program writes them. */
    private static String decimals(String numbers) {
        return Stream.of(numbers.split(", "))
                .map(number -> Double.toString(Double.parseDouble(number)))
                .collect(Collectors.joining(", "));
    }
}
