package faultline.studies;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.wallfollower.StateDiagram;
import faultline.paint.surface.SvgTheme;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The checked-in results are what the program makes today. If they are not, make them again: {@code java -jar
 * target/faultline.jar figures --out docs/results}.
 */
class FiguresTest {

    private static final Path CHECKED_IN = Path.of("docs/results");

    @TempDir
    private static Path fresh;

    /** Makes the figures in a language with digits of its own, so that none of them may depend on the language. */
    @BeforeAll
    static void makeAll() throws IOException {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("ar-EG"));
            Figures.writeAll(fresh, SvgTheme.ADAPTIVE, (done, all) -> {});
        } finally {
            Locale.setDefault(before);
        }
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(Files::isRegularFile)
                    .map(file -> file.getFileName().toString())
                    .sorted()
                    .toList();
        }
    }

    @Test
    void theSameFilesAreMadeAsAreCheckedIn() throws IOException {
        assertEquals(names(CHECKED_IN), names(fresh));
    }

    @Test
    void everyPictureAndTableIsTheCheckedInOneByteForByte() throws IOException {
        for (String name : names(fresh)) {
            // Letters as pixels depend on the machine's fonts; lines do not. The picture of pixels
            // has a test of its
            // own.
            if (!name.endsWith(".png")) {
                assertArrayEquals(
                        Files.readAllBytes(CHECKED_IN.resolve(name)), Files.readAllBytes(fresh.resolve(name)), name);
            }
        }
    }

    @Test
    void theControlPanelResemblesTheCheckedInImage() throws IOException {
        double[] now = coarseGreys(fresh.resolve("fig1-panel.png"));
        double[] then = coarseGreys(CHECKED_IN.resolve("fig1-panel.png"));
        double off = IntStream.range(0, now.length)
                .mapToDouble(i -> Math.abs(now[i] - then[i]))
                .average()
                .orElseThrow();
        assertTrue(off < 4, off + " of 255 greys");
    }

    /** The picture's greys on a coarse grid, on which one font is like another. */
    private static double[] coarseGreys(Path file) throws IOException {
        BufferedImage coarse = new BufferedImage(24, 48, BufferedImage.TYPE_INT_RGB);
        coarse.createGraphics()
                .drawImage(
                        ImageIO.read(file.toFile()).getScaledInstance(24, 48, Image.SCALE_AREA_AVERAGING), 0, 0, null);
        return IntStream.of(coarse.getRGB(0, 0, 24, 48, null, 0, 24))
                .mapToDouble(rgb -> ((rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255)) / 3.0)
                .toArray();
    }

    @Test
    void everyPictureIsGoodXml() throws Exception {
        for (String name : names(fresh)) {
            if (name.endsWith(".svg")) {
                assertEquals(
                        "svg",
                        DocumentBuilderFactory.newDefaultInstance()
                                .newDocumentBuilder()
                                .parse(fresh.resolve(name).toFile())
                                .getDocumentElement()
                                .getTagName(),
                        name);
            }
        }
    }

    @Test
    void everyPictureHasACaptionThatSaysHowManyRunsItShows() throws IOException {
        List<String> withoutRuns = List.of("fig2-moves.svg", "fig3-frames.svg", "fig8-states.svg");
        Pattern caption = Pattern.compile("<text x=\"14\"[^>]*>[^<]{20,}");
        for (String name : names(fresh)) {
            if (name.endsWith(".svg")) {
                String picture = Files.readString(fresh.resolve(name));
                assertTrue(caption.matcher(picture).find(), name);
                assertTrue(withoutRuns.contains(name) || picture.contains("n\u00a0=\u00a0"), name);
            }
        }
    }

    @Test
    void theStateDiagramNamesEveryArrowOfTheTable() throws IOException {
        String picture = Files.readString(fresh.resolve("fig8-states.svg"));
        for (StateDiagram.Arrow arrow : StateDiagram.TRANSITIONS) {
            assertTrue(picture.contains(">" + arrow.from() + " \u2192 " + arrow.to() + "<"), arrow.toString());
        }
    }

    @Test
    void everyScenarioFileOfTheStudiesIsNamedInTheResults() throws IOException {
        String results = Files.readString(Path.of("docs/results.md"));
        assertEquals(
                List.of(),
                names(Path.of("scenarios/studies")).stream()
                        .filter(name -> !results.contains("scenarios/studies/" + name))
                        .toList());
    }

    @Test
    void everyFigureStandsInTheResults() throws IOException {
        String results = Files.readString(Path.of("docs/results.md"));
        assertEquals(
                List.of(),
                names(fresh).stream()
                        .filter(name -> !results.contains("results/" + name))
                        .toList());
    }
}
