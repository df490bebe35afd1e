package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.plan.SamplePlan;
import faultline.campaign.report.CampaignCell;
import faultline.campaign.run.ResultColumns;
import faultline.gui.ComponentFinder;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
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

    private JTable table(int tab) {
        return ComponentFinder.findAll(tabs.getComponentAt(tab), JTable.class)
                .findFirst()
                .orElseThrow();
    }

    private String text(int tab, int row, int column) {
        return callOnEdt(() -> String.valueOf(table(tab).getValueAt(row, column)));
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

    /** The faults of a batch have no end; those of a campaign may differ in nothing else. */
    @Test
    void theEndOfFaultsShowsAsSoonAsAFaultHasOne() throws Exception {
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text(
                        "",
                        """
                <worlds><scenario file="a.xml"/></worlds>
                <set attribute="@duration" value="3 4" name="extend_s"/>
                <faults><healthy/><fault kind="stuck" sensor="left" value="0.3" at="1" lasts="1 2"/></faults>
                """));
        List<String> header = ResultColumns.of(plan).stream().map(Column::name).toList();
        runOnEdt(() -> {
            BatchResults results = new BatchResults(plan);
            ResultTabs shown = new ResultTabs(tabs, results, row -> {});
            List<String> columns = List.of("extend_s", "fault_kind", "fault_sensor", "fault_value", "fault_onset_s");
            assertEquals(columns, results.runColumns().subList(2, 7));
            results.add(row(header, "0", ""));
            shown.update(List.of());
            assertEquals("Outcome", table(1).getColumnName(7));
            results.add(row(header, "1", "2.0"));
            shown.update(List.of());
            assertEquals("End, s", table(1).getColumnName(7));
            assertEquals("2.0", String.valueOf(table(1).getValueAt(1, 7)));
        });
    }

    /** Returns a row with a number and an end of a fault. */
    private static List<String> row(List<String> header, String run, String end) {
        List<String> row = new ArrayList<>(Collections.nCopies(header.size(), ""));
        row.set(0, run);
        row.set(header.indexOf("fault_end_s"), end);
        return row;
    }

    /** Shows the results of all runs that a batch has made. */
    private void show(BatchRun run) {
        BatchResults results = new BatchResults(run.planOrNull());
        ResultTabs shown = new ResultTabs(tabs, results, row -> {});
        for (List<String> row = run.takeRow(); row != null; row = run.takeRow()) {
            results.add(row);
        }
        shown.update(run.cells());
    }

    @Test
    void aChangeOfTheLanguageTranslatesTheResults() throws Exception {
        BatchRun run = twoRuns();
        runOnEdt(() -> show(run));
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

    /** Without a word, a few runs looked like all of them. */
    @Test
    void theRunsOfTheSelectedCellAreSaidToBeSomeAndAllCanBeShown() throws Exception {
        BatchRun run = twoRuns();
        runOnEdt(() -> {
            show(run);
            for (int tab : new int[] {1, 2}) {
                ShownRunsBar bar = ComponentFinder.findAll(tabs.getComponentAt(tab), ShownRunsBar.class)
                        .findFirst()
                        .orElseThrow();
                assertFalse(bar.isVisible());
                table(0).setRowSelectionInterval(0, 0);
                assertTrue(bar.isVisible());
                assertEquals(
                        "Runs of \"no fault\", the selected row of the summary: 1 of 2",
                        ComponentFinder.findAll(bar, JLabel.class)
                                .findFirst()
                                .orElseThrow()
                                .getText());
                ComponentFinder.find(bar, JButton.class, "Show all").doClick(0);
                assertFalse(bar.isVisible());
                assertEquals(2, table(1).getRowCount());
            }
        });
        run.delete();
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
            assertEquals(ResultTabs.BLOCK, table(1).getRowCount());
            return table(1);
        });
        run.delete();
        // Each block is an event of its own.
        runOnEdt(() -> {});
        runOnEdt(() -> {});
        assertEquals(count, callOnEdt(runs::getRowCount));
        assertEquals(Integer.toString(count - 1), callOnEdt(() -> String.valueOf(runs.getValueAt(count - 1, 0))));
    }

    /** A batch is continued whose table lacks its last rows. */
    @Test
    void aRunThatIsMadeAgainReplacesItsRowAndThoseBehindIt() throws Exception {
        BatchRun run = twoRuns();
        List<String> row = run.takeRow();
        run.delete();
        CampaignCell cell = run.cells().get(0);
        runOnEdt(() -> {
            BatchResults results = new BatchResults(run.planOrNull());
            ResultTabs shown = new ResultTabs(tabs, results, index -> {});
            for (int i : new int[] {0, 1, 2, 3}) {
                shown.add(withNumber(row, i));
            }
            shown.update(List.of(cell, withRuns(cell, List.of(3L))));
            table(0).setRowSelectionInterval(1, 1);
            assertEquals(1, table(1).getRowCount());
            shown.add(withNumber(row, 1));
            shown.update(List.of(cell));
            assertEquals(List.of(0L, 1L), List.copyOf(results.runs()));
            assertEquals(1, table(0).getRowCount());
            assertEquals(2, table(1).getRowCount());
            assertEquals(2, results.numbers("run", results.runs()).length);
        });
    }

    private static List<String> withNumber(List<String> row, int number) {
        List<String> next = new ArrayList<>(row);
        next.set(0, Integer.toString(number));
        return next;
    }

    /** All rows of a large campaign at once would block the window for seconds. */
    @Test
    void manyRowsAreTranslatedWhileOtherEventsAreHandled() throws Exception {
        BatchRun run = twoRuns();
        List<String> row = run.takeRow();
        run.delete();
        int last = ResultTabs.BLOCK;
        runOnEdt(() -> {
            BatchResults results = new BatchResults(run.planOrNull());
            ResultTabs shown = new ResultTabs(tabs, results, index -> {});
            for (int i = 0; i <= last; i++) {
                shown.add(withNumber(row, i));
            }
            shown.update(run.cells());
            table(1).getRowSorter().toggleSortOrder(2);
        });
        runOnEdt(() -> {});
        runOnEdt(() -> {
            Messages.setLanguage(Language.POLISH);
            ComponentFinder.tree(tabs).forEach(RefreshSteps::run);
            assertEquals("bez uszkodzenia", String.valueOf(table(1).getValueAt(0, 2)));
            assertEquals("no fault", String.valueOf(table(1).getValueAt(last, 2)));
        });
        runOnEdt(() -> {});
        assertEquals("bez uszkodzenia", text(1, last, 2));
        assertEquals(last + 1, callOnEdt(() -> table(1).getRowCount()));
    }

    @Test
    void noRowIsSetAgainForAnotherThemeOrTextSize() throws Exception {
        BatchRun run = twoRuns();
        runOnEdt(() -> show(run));
        run.delete();
        runOnEdt(() -> {
            List<Object> changes = new ArrayList<>();
            table(0).getModel().addTableModelListener(changes::add);
            table(1).getModel().addTableModelListener(changes::add);
            ComponentFinder.tree(tabs).forEach(RefreshSteps::run);
            assertEquals(List.of(), changes);
        });
    }

    private static CampaignCell withRuns(CampaignCell cell, List<Long> runs) {
        return new CampaignCell(
                cell.labels(),
                cell.sum(),
                runs,
                cell.carriedOn(),
                cell.withoutContact(),
                cell.coverageOrNaN(),
                cell.distanceRmsOrNaN());
    }

    /** To sort a million runs takes seconds. */
    @Test
    void theRunsOfTheSelectedCellAreFilteredAgainOnlyIfTheyHaveChanged() throws Exception {
        BatchRun run = twoRuns();
        List<String> row = run.takeRow();
        runOnEdt(() -> {
            BatchResults results = new BatchResults(run.planOrNull());
            for (int i = 0; i < 100; i++) {
                List<String> next = new ArrayList<>(row);
                next.set(0, Integer.toString(i));
                results.add(next);
            }
            CampaignCell cell = run.cells().get(0);
            ResultTabs shown = new ResultTabs(tabs, results, index -> {});
            shown.update(List.of(withRuns(cell, List.of(1L, 3L))));
            table(0).setRowSelectionInterval(0, 0);
            table(1).getRowSorter().toggleSortOrder(0);
            assertEquals(2, table(1).getRowCount());
            List<Object> sorted = new ArrayList<>();
            table(1).getRowSorter().addRowSorterListener(sorted::add);
            shown.update(List.of(withRuns(cell, List.of(1L, 3L))));
            assertEquals(List.of(), sorted);
            shown.update(List.of(withRuns(cell, List.of(1L, 3L, 90L, 98L))));
            assertEquals(4, table(1).getRowCount());
            assertEquals("98", String.valueOf(table(1).getValueAt(3, 0)));
            table(0).clearSelection();
            assertEquals(100, table(1).getRowCount());
            table(0).setRowSelectionInterval(0, 0);
            shown.update(List.of(withRuns(cell, List.of(5L, 3L))));
            assertEquals(2, table(1).getRowCount());
        });
        run.delete();
    }
}
