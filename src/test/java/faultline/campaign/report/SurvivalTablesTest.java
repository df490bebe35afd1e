package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The survival tables of the results and the delays of the page on faults say what the csv files beside them say. */
class SurvivalTablesTest {

    private static final Path FOLDER = Path.of("docs/results/survival");

    @TempDir
    private Path folder;

    @Test
    void theTextHoldsTheTablesOfTheFiles() throws IOException {
        assertEquals(
                SurvivalTables.markdown(FOLDER), SurvivalTables.block(Files.readString(Path.of("docs/results.md"))));
    }

    /** In two rooms, some faults are not detected in any run. */
    @Test
    void aFaultThatNoRunDetectsHasADashForItsMedian() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            for (Path file : files.toList()) {
                Files.copy(file, folder.resolve(file.getFileName()));
            }
        }
        Path table = folder.resolve("detection.csv");
        List<String> lines = Files.readAllLines(table).stream()
                .map(line -> line.startsWith("off,front,all,")
                        ? "off,front,all,2,2,1.0000,0.3424,1.0000,0,0,0,0,0,0,,,0,,"
                        : line)
                .toList();
        Files.write(table, lines);
        assertTrue(SurvivalTables.markdown(folder).contains("\n| off, s | \u2013 (0 of 2) | "));
    }

    @Test
    void thePageOnFaultsHasTheDelaysOfTheFile() throws IOException {
        List<Map<String, String>> cells = SurvivalTables.read(FOLDER, "survival");
        String page = Files.readString(Path.of("docs/faults.md"));
        List<String> rows = page.substring(page.indexOf("| fault | `left`: found"))
                .lines()
                .takeWhile(line -> line.startsWith("|"))
                .skip(2)
                .toList();
        assertEquals(11, rows.size());
        for (String row : rows) {
            String[] said = row.substring(2, row.length() - 2).split(" \\| ");
            Map<String, String> left = cell(cells, "on", said[0], "left");
            Map<String, String> front = cell(cells, "on", said[0], "front");
            assertEquals(left.get("detected"), said[1], row);
            assertSaid(said[2], left.get("delay_median_s"), row);
            assertSaid(said[3], left.get("delay_90_s"), row);
            assertEquals(front.get("detected"), said[4], row);
            assertSaid(said[5], front.get("delay_median_s"), row);
            assertSaid(said[6], front.get("delay_90_s"), row);
        }
    }

    @Test
    void theVerdictHasTheSharesWithoutDiagnosis() throws IOException {
        List<Map<String, String>> cells = SurvivalTables.read(FOLDER, "survival");
        String said = String.format(
                Locale.ROOT,
                "%s %% and %s %% of the runs carry on. The six states also watch the diagonal front sensors, so false"
                        + " surfaces there, such as ghosts or negative drift, stop the progress too: %s %% carry on"
                        + " when `front-left` fails, %s %% when `front-right` does.",
                percentWithout(cells, "left"),
                percentWithout(cells, "front"),
                percentWithout(cells, "front-left"),
                percentWithout(cells, "front-right"));
        String text = Files.readString(Path.of("docs/results.md")).replaceAll("\\s+", " ");
        assertTrue(text.contains(said), () -> "the results should say: " + said);
        for (String sensor : List.of("right", "rear-left", "rear", "rear-right")) {
            assertEquals("100", percentWithout(cells, sensor));
        }
    }

    private static String percentWithout(List<Map<String, String>> cells, String sensor) {
        String share = cell(cells, "off", "all", sensor).get("share");
        return String.format(Locale.ROOT, "%.0f", 100 * Double.parseDouble(share));
    }

    private static Map<String, String> cell(
            List<Map<String, String>> cells, String diagnosis, String fault, String sensor) {
        return cells.stream()
                .filter(row -> row.get("controller_diagnosis").equals(diagnosis)
                        && row.get("final_rung").equals("all")
                        && row.get("fault_label").equals(fault)
                        && row.get("fault_sensor").equals(sensor))
                .findFirst()
                .orElseThrow();
    }

    /** A number is said with as many decimals as the page gives it. */
    private static void assertSaid(String said, String value, String row) {
        int decimals = said.length() - said.indexOf('.') - 1;
        assertEquals(String.format(Locale.ROOT, "%." + decimals + "f", Double.parseDouble(value)), said, row);
    }
}
