package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.Shard;
import faultline.gui.ComponentFinder;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The results of a batch that are read again, and what is said about other folders. Without a display. */
class OpenedResultsTest {

    @TempDir
    private Path folder;

    private BatchRun run;
    private Path saved;

    /** Makes six runs: two seeds, without a fault and with one of two. */
    @BeforeEach
    void makeBatch() throws Exception {
        Scenario yard = Scenario.load(Path.of("scenarios/yard.xml"));
        run = new BatchRun(
                new BatchPlan(
                        yard,
                        7,
                        2,
                        2,
                        false,
                        DiagnosisChoice.SCENARIO,
                        true,
                        List.of(new BatchPlan.FaultValues("stuck", "0.3"), new BatchPlan.FaultValues("off", "")),
                        "1",
                        List.of("left")),
                1);
        run.make();
        saved = folder.resolve("saved");
        run.saveResults(saved);
        run.delete();
    }

    @AfterEach
    void restoreLanguage() {
        Messages.setLanguage(Language.ENGLISH);
    }

    private List<List<String>> rowsOfBatch() {
        List<List<String>> rows = new ArrayList<>();
        for (List<String> row = run.takeRow(); row != null; row = run.takeRow()) {
            rows.add(row);
        }
        return rows;
    }

    private static List<String> columnsAndRows(BatchResults results) {
        List<String> texts = new ArrayList<>(results.runColumns());
        for (int row = 0; row < results.size(); row++) {
            texts.add(results.runRow(row).toString());
        }
        return texts;
    }

    @Test
    void resultsAreTheSameAsAfterTheBatch() throws Exception {
        OpenedResults opened = OpenedResults.read(saved);
        BatchResults before = new BatchResults(run.planOrNull());
        rowsOfBatch().forEach(before::add);
        assertEquals(columnsAndRows(before), columnsAndRows(opened.results()));
        assertEquals(run.cells(), opened.cells());
        assertEquals(run.repeatCount(), opened.repeats());
        assertEquals("Batch of Yard", opened.name());
        assertEquals("Runs: 6, failed: 0. Runs that repeat another one, except for the seed: 3", opened.status());
    }

    @Test
    void aFileOfTheResultsStandsForItsFolder() throws Exception {
        for (Path chosen : List.of(saved, saved.resolve("runs.csv"), saved.resolve("campaign.json"))) {
            assertEquals(saved, OpenedResults.read(chosen).folder());
            assertEquals(saved.getFileName().toString(), OpenedResults.nameOf(chosen));
        }
        assertEquals("notes.txt", OpenedResults.nameOf(saved.resolve("notes.txt")));
    }

    /** The second half begins with run 3. */
    @Test
    void theRunsOfAPartAreFoundByTheirNumbers() throws Exception {
        Path part = folder.resolve("part");
        new CampaignRunner(run.planOrNull(), new CampaignFolder(part), new Shard(2, 2), 1)
                .run(false, (made, runs) -> {}, () -> false);
        OpenedResults opened = OpenedResults.read(part);
        assertEquals("Runs: 3 of 6, failed: 0", opened.status());
        BatchResults results = opened.results();
        assertEquals(3, results.run(0));
        assertEquals(3, results.numbers("simulated_s", results.runs()).length);
        assertEquals(1, results.numbers("simulated_s", List.of(5L)).length);
        assertEquals(0, results.numbers("simulated_s", List.of(0L)).length);
        JTabbedPane tabs = callOnEdt(() -> {
            Theme.LIGHT.install();
            JTabbedPane pane = new JTabbedPane();
            new ResultTabs(pane, results, row -> {}).update(opened.cells());
            return pane;
        });
        JTable cells = table(tabs, 0);
        JTable runs = table(tabs, 1);
        assertEquals(3, callOnEdt(runs::getRowCount));
        runOnEdt(() -> cells.setRowSelectionInterval(1, 1));
        assertEquals(1, callOnEdt(runs::getRowCount));
        assertEquals("4", callOnEdt(() -> String.valueOf(runs.getValueAt(0, 0))));
    }

    private static JTable table(JTabbedPane tabs, int tab) {
        return callOnEdt(() -> ComponentFinder.findAll(tabs.getComponentAt(tab), JTable.class)
                .findFirst()
                .orElseThrow());
    }

    @Test
    void anUnfinishedRowIsLeftOut() throws Exception {
        String table = Files.readString(saved.resolve("runs.csv"));
        Files.writeString(saved.resolve("runs.csv"), table.substring(0, table.length() - 60));
        assertEquals("Runs: 5 of 6, failed: 0. Runs that repeat another one, except for the seed: 2", status());
    }

    private String status() throws Exception {
        return OpenedResults.read(saved).status();
    }

    @Test
    void resultsOfAnotherProgramAreMarked() throws Exception {
        Path manifest = saved.resolve("campaign.json");
        Files.writeString(manifest, Files.readString(manifest).replaceFirst("\"program_sha256\": \"", "$0abc"));
        assertTrue(
                status().endsWith(". The plan, the program or its jars have changed or are not known: runs may differ"),
                status());
        Files.delete(manifest);
        assertTrue(status().endsWith(": runs may differ"), status());
    }

    private String refusal(Path chosen) {
        try {
            OpenedResults.read(chosen);
            return "";
        } catch (Exception failure) {
            return OpenedResults.failureText(chosen, failure);
        }
    }

    @Test
    void aFolderWithoutResultsIsRefused() throws Exception {
        String rule = " cannot be opened: it is not a folder with the results of a batch or campaign, which has the"
                + " files runs.csv and plan/plan.xml.";
        assertEquals("empty" + rule, refusal(Files.createDirectory(folder.resolve("empty"))));
        assertEquals("missing" + rule, refusal(folder.resolve("missing")));
        assertEquals("note.csv" + rule, refusal(Files.writeString(folder.resolve("note.csv"), "a,b\n")));
    }

    @Test
    void damagedResultsAreRefusedWithTheFileAndTheReason() throws Exception {
        Path table = saved.resolve("runs.csv");
        List<String> lines = Files.readAllLines(table);
        String begin = "The results in saved cannot be opened: ";
        writeTable(lines.get(0));
        assertEquals(
                begin + "runs.csv:1:1: there is no row of a run; expected at least one below the header.",
                refusal(table));
        writeTable("a,b", "1,2");
        assertEquals(
                begin + "runs.csv:1:1: the header has no column \"run\"; expected names with commas between them.",
                refusal(table));
        writeTable(lines.get(0), "0,0", lines.get(2));
        assertEquals(
                begin + "runs.csv:2: the row has 2 cells; expected "
                        + lines.get(0).split(",").length + " like the header.",
                refusal(table));
        writeTable(lines.get(0), lines.get(1).replace(",undecided,", ",won,"));
        assertTrue(refusal(table).startsWith(begin + "runs.csv:2: outcome is \"won\"; expected one of "));
        Messages.setLanguage(Language.POLISH);
        assertTrue(
                refusal(table)
                        .startsWith("Nie można otworzyć wyników z saved: runs.csv:2: outcome to \"won\"; dozwolone: "),
                refusal(table));
    }

    private void writeTable(String... lines) throws IOException {
        Files.writeString(saved.resolve("runs.csv"), String.join("\n", lines) + "\n");
    }

    @Test
    void resultsWithoutTheirPlanAreRefused() throws Exception {
        Path plan = saved.resolve("plan/plan.xml");
        String text = Files.readString(plan);
        Files.delete(plan);
        String missing = refusal(saved);
        assertTrue(missing.startsWith("The results in saved cannot be opened: plan.xml: "), missing);
        Files.writeString(plan, text.substring(0, text.length() - 20));
        String cut = refusal(saved);
        assertTrue(cut.startsWith("The results in saved cannot be opened: plan.xml:"), cut);
        Files.writeString(plan, text.replace("<seeds", "<set attribute=\"controller/@type\" value=\"mine\"/><seeds"));
        String unknown = refusal(saved);
        assertTrue(unknown.endsWith("; add its jar with Choose controller first."), unknown);
        Files.writeString(plan, text);
        Path scenario = saved.resolve("plan/scenario-1.xml");
        Files.writeString(
                scenario, Files.readString(scenario).replaceFirst("<controller .*/>", "<controller type=\"mine\"/>"));
        String named = refusal(saved);
        assertTrue(named.endsWith("; add its jar with Choose controller first."), named);
    }
}
