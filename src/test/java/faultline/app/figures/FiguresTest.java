package faultline.app.figures;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.StateDiagram;
import faultline.paint.plot.Appearance;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The checked-in results are what the program makes today. Where they are not, make them anew: {@code java -jar target/faultline.jar figures --out docs/results}. */
class FiguresTest {

    private static final Path CHECKED_IN = Path.of("docs/results");

    @TempDir
    private static Path fresh;

    @BeforeAll
    static void makeAll() throws IOException {
        Figures.make(fresh, Appearance.ADAPTIVE, (done, all) -> { });
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void theSameFilesAreMadeAsAreCheckedIn() throws IOException {
        assertEquals(names(CHECKED_IN), names(fresh));
    }

    @Test
    void everyPictureAndTableIsTheCheckedInOneByteForByte() throws IOException {
        for (String name : names(fresh)) {
            // Pixels of letters hang on the machine's fonts; all that is drawn as lines does not.
            if (!name.endsWith(".png")) {
                assertArrayEquals(Files.readAllBytes(CHECKED_IN.resolve(name)), Files.readAllBytes(fresh.resolve(name)), name);
            }
        }
    }

    @Test
    void everyPictureIsGoodXml() throws Exception {
        for (String name : names(fresh)) {
            if (name.endsWith(".svg")) {
                assertEquals("svg", DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder().parse(fresh.resolve(name).toFile())
                        .getDocumentElement().getTagName(), name);
            }
        }
    }

    @Test
    void theStateDiagramNamesEveryArrowOfTheTable() throws IOException {
        String picture = Files.readString(fresh.resolve("fig8-states.svg"));
        for (StateDiagram.Arrow arrow : StateDiagram.ARROWS) {
            assertTrue(picture.contains(">" + arrow.from() + " \u2192 " + arrow.to() + "<"), arrow.toString());
        }
    }

    @Test
    void everyScenarioFileOfTheStudiesIsNamedInTheResults() throws IOException {
        String results = Files.readString(Path.of("docs/results.md"));
        assertEquals(List.of(), names(Path.of("scenarios/studies")).stream().filter(name -> !results.contains("scenarios/studies/" + name)).toList());
    }

    @Test
    void everyFigureStandsInTheResults() throws IOException {
        String results = Files.readString(Path.of("docs/results.md"));
        assertEquals(List.of(), names(fresh).stream().filter(name -> !results.contains("results/" + name)).toList());
    }
}
