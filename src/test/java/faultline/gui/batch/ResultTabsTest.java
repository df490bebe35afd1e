package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.campaign.report.CampaignCell;
import faultline.gui.ComponentFinder;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The tables of a batch, without a display. */
class ResultTabsTest {

    private final JTabbedPane tabs = callOnEdt(() -> {
        Theme.LIGHT.install();
        return new JTabbedPane();
    });

    @AfterEach
    void restoreLanguage() {
        runOnEdt(() -> Messages.setLanguage(Language.ENGLISH));
    }

    private String text(int tab, int row, int column) {
        return callOnEdt(() -> {
            JTable table = ComponentFinder.findAll(tabs.getComponentAt(tab), JTable.class)
                    .findFirst()
                    .orElseThrow();
            return String.valueOf(table.getValueAt(row, column));
        });
    }

    /** Returns a finished batch of two runs. */
    private static BatchRun twoRuns() throws Exception {
        Scenario yard = Scenario.load(Path.of("scenarios/yard.xml"));
        BatchRun run = new BatchRun(
                new BatchPlan(
                        yard,
                        77,
                        1,
                        3,
                        false,
                        DiagnosisChoice.SCENARIO,
                        true,
                        List.of(new BatchPlan.FaultValues("stuck", "0.3")),
                        "1..2",
                        List.of("left")),
                1);
        assertEquals(2, run.make().made());
        return run;
    }

    /** Totals come after the first block of runs; a variant may have the word for them as its name. */
    @Test
    void aVariantThatIsCalledAllIsNoTotal() throws Exception {
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text(
                        "",
                        """
                <worlds><scenario file="a.xml"/></worlds>
                <seeds count="2"/>
                <variants><variant name="all"/><variant name="few"/></variants>
                """));
        List<CampaignCell> cells = BatchResults.cellsOf(
                plan,
                List.of(
                        List.of("run", "block", "world", "variant", "carried_on"),
                        List.of("0", "0", "a", "all", "1"),
                        List.of("1", "0", "a", "few", "1"),
                        List.of("2", "1", "a", "all", "1")));
        assertEquals(
                List.of(List.of("all"), List.of("few")),
                cells.stream().map(CampaignCell::labels).toList());
    }

    @Test
    void aChangeOfTheLanguageTranslatesTheResults() throws Exception {
        BatchRun run = twoRuns();
        runOnEdt(() -> {
            BatchResults results = new BatchResults(run.planOrNull());
            ResultTabs shown = new ResultTabs(tabs, results, row -> {});
            for (List<String> row = run.takeRow(); row != null; row = run.takeRow()) {
                results.add(row);
            }
            shown.update(run.cells());
        });
        run.delete();
        assertEquals(List.of("no fault", "no fault", "stuck"), List.of(text(0, 0, 0), text(1, 0, 2), text(1, 1, 2)));
        runOnEdt(() -> {
            Messages.setLanguage(Language.POLISH);
            ComponentFinder.tree(tabs).forEach(RefreshSteps::run);
        });
        assertEquals(
                List.of("bez uszkodzenia", "bez uszkodzenia", "zacięty"),
                List.of(text(0, 0, 0), text(1, 0, 2), text(1, 1, 2)));
    }

    @Test
    void manyRowsAreAddedWhileOtherEventsAreHandled() throws Exception {
        BatchRun run = twoRuns();
        List<String> row = run.takeRow();
        int count = 2 * ResultTabs.BLOCK + 1;
        JTable runs = callOnEdt(() -> {
            BatchResults results = new BatchResults(run.planOrNull());
            for (int i = 0; i < count; i++) {
                List<String> next = new ArrayList<>(row);
                next.set(0, Integer.toString(i));
                results.add(next);
            }
            new ResultTabs(tabs, results, index -> {}).update(run.cells());
            JTable table = ComponentFinder.findAll(tabs.getComponentAt(1), JTable.class)
                    .findFirst()
                    .orElseThrow();
            assertEquals(ResultTabs.BLOCK, table.getRowCount());
            return table;
        });
        run.delete();
        // Each block is an event of its own.
        runOnEdt(() -> {});
        runOnEdt(() -> {});
        assertEquals(count, callOnEdt(runs::getRowCount));
        assertEquals(Integer.toString(count - 1), callOnEdt(() -> String.valueOf(runs.getValueAt(count - 1, 0))));
    }
}
