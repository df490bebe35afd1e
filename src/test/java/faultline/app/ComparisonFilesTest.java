package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.report.ControllerComparison;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioLimits;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ComparisonFilesTest {

    @ParameterizedTest
    @CsvSource({
        "page.html, page.csv, page-2.xml",
        "page.htm, page.csv, page-2.xml",
        "page, page.csv, page-2.xml",
        "a.html.b, a.html.b.csv, a.html.b-2.xml"
    })
    void theOtherFilesHaveTheNameOfThePage(String page, String table, String replay) throws UsageException {
        ComparisonFiles files = new ComparisonFiles(Path.of("folder", page), 2);
        assertEquals(Path.of("folder", page), files.page());
        assertEquals(Path.of("folder", table), files.table());
        assertEquals(Path.of("folder", replay), files.replay(1));
    }

    @Test
    void aReplayThatCannotBeSavedDoesNotKeepTheOthers(@TempDir Path folder) throws Exception {
        Scenario scenario = Scenario.loadShipped("office.xml");
        String text = "x".repeat((int) ScenarioLimits.MAX_BYTES);
        Scenario large = new Scenario("large", text, false, scenario.setup(), scenario.expectation());
        try (ComparisonFiles files = new ComparisonFiles(folder.resolve("page.html"), 2)) {
            files.open();
            Map<Path, Scenario> replays = new LinkedHashMap<>(Map.of(files.replay(0), large));
            replays.put(files.replay(1), scenario);
            assertEquals(
                    List.of("faultline: " + files.replay(0)
                            + ": the scenario cannot be saved: the file has 16.1 MiB; expected at most 16 MiB"),
                    CompareCommand.writeReplays(files, replays));
            assertEquals(Set.of(files.replay(1)), replays.keySet());
            files.commit();
            assertTrue(Files.exists(files.replay(1)));
            assertFalse(Files.exists(files.replay(0)));
        }
    }

    @Test
    void theFilesOfAnEarlierComparisonAreReplaced(@TempDir Path folder) throws Exception {
        Scenario room = Scenario.loadShipped("office.xml");
        Scenario replay = new Scenario("", "", true, room.setup(), room.expectation());
        try (ComparisonFiles files = new ComparisonFiles(folder.resolve("page.html"), 1)) {
            Files.writeString(files.table(), ControllerComparison.csvHeader() + "none,1,0.5,,0.0,1,NONE,00,\n");
            replay.save(files.replay(0));
            files.open();
            files.write(files.table(), new byte[0]);
            files.commit();
            assertEquals(0, Files.size(files.table()));
            assertFalse(Files.exists(files.replay(0)));
        }
    }

    @Test
    void aScenarioThatIsNoRecordIsNotReplaced(@TempDir Path folder) throws Exception {
        try (ComparisonFiles files = new ComparisonFiles(folder.resolve("page.html"), 1)) {
            Scenario.loadShipped("office.xml").save(files.replay(0));
            assertThrows(IOException.class, files::open);
        }
    }
}
