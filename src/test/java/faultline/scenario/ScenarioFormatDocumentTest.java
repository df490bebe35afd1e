package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

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
    void theExampleIsAGoodScenario() throws Exception {
        List<String> examples = all("```xml\n(.*?)```", Files.readString(DOCUMENT));
        assertEquals(1, examples.size());
        assertEquals(List.of(), SampleScenario.problems(examples.get(0)));
    }
}
