package faultline.gui.batch;

import faultline.campaign.report.CampaignCell;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.FocusRing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import java.awt.EventQueue;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.event.ListSelectionEvent;

/**
 * The cells, the runs and the histogram of a batch. The selected cell limits the runs and the histogram to its runs.
 */
final class ResultTabs {

    /** The number of rows of runs that are set at a time. */
    static final int BLOCK = 2000;

    private final JTabbedPane tabs;
    private final BatchResults results;
    private final ResultTable cellTable;
    private final ResultTable runTable;
    private final HistogramView histogram;
    private final List<ShownRunsBar> bars;
    private final int firstTab;
    private List<CampaignCell> cells = List.of();
    /** Whether more rows of runs will be set when other events have been handled. */
    private boolean settingRows;
    /** The number of rows of runs in the current language; these are the first ones. */
    private int currentRows;
    /** The language of these rows. */
    private Language language = Messages.language();

    /** The runs of the selected cell, which their table shows; null for all. */
    private Set<Long> shownRuns;

    /**
     * Adds the tabs of a batch behind those that are there; {@code onOpen} receives the row of a run that the user
     * opens.
     */
    ResultTabs(JTabbedPane tabs, BatchResults results, IntConsumer onOpen) {
        this.tabs = tabs;
        this.results = results;
        firstTab = tabs.getTabCount();
        cellTable = new ResultTable("batch.tab.cells", results.cellColumns(), this::showRuns);
        runTable = new ResultTable("batch.tab.runs", results.runColumns(), onOpen);
        histogram = new HistogramView(quantity -> results.numbers(quantity.column(), selectedRuns()));
        cellTable.getSelectionModel().addListSelectionListener(this::cellSelected);
        addTab("batch.tab.cells", scrolled(cellTable));
        bars = List.of(
                ShownRunsBar.below(scrolled(runTable), this::showAllRuns),
                ShownRunsBar.below(histogram, this::showAllRuns));
        addTab("batch.tab.runs", (JComponent) bars.get(0).getParent());
        addTab("batch.tab.histogram", (JComponent) bars.get(1).getParent());
        histogram.update();
        RefreshSteps.add(runTable, table -> translateRows());
    }

    /** Returns rows of runs, in the current language. */
    private List<List<ResultCell>> runRows(int first, int end) {
        return IntStream.range(first, end).mapToObj(results::runRow).toList();
    }

    /** Sets the next rows of runs, and the others when other events have been handled, because they may be many. */
    private void setNextRows() {
        int end = Math.min(results.size(), currentRows + BLOCK);
        runTable.setRows(currentRows, runRows(currentRows, end));
        currentRows = end;
        settingRows = end < results.size();
        if (settingRows) {
            EventQueue.invokeLater(this::setNextRows);
        }
    }

    /** Sets all rows again if the language has changed. Their texts do not depend on the theme. */
    private void translateRows() {
        if (language != Messages.language()) {
            language = Messages.language();
            cellTable.setRows(cells.stream().map(results::cellRow).toList());
            currentRows = 0;
            if (!settingRows) {
                setNextRows();
            }
        }
    }

    /**
     * Adds a row to the results, which shows with the next update. If its run has a row, the runs from that one on are
     * made a second time, and their rows are removed.
     */
    void add(List<String> row) {
        results.firstRow(List.of(Long.parseLong(row.get(0)))).ifPresent(this::keepRows);
        results.add(row);
    }

    /** Removes all rows of runs but the first ones. */
    void keepRows(int count) {
        if (count < results.size()) {
            results.keepRows(count);
            runTable.keepRows(count);
            currentRows = Math.min(count, currentRows);
        }
    }

    private void addTab(String key, JComponent view) {
        UiText.addTab(tabs, key, view);
    }

    private static JScrollPane scrolled(ResultTable table) {
        JScrollPane scroll = new JScrollPane(table);
        scroll.setBorder(new FocusRing.FocusBorder(false));
        return scroll;
    }

    void remove() {
        while (tabs.getTabCount() > firstTab) {
            tabs.removeTabAt(firstTab);
        }
    }

    /** Shows the cells. */
    void select() {
        tabs.setSelectedIndex(firstTab);
        focusTable();
    }

    /** Moves the focus to the table that shows. */
    void focusTable() {
        Stream.of(cellTable, runTable).filter(ResultTable::isShowing).forEach(ResultTable::requestFocusInWindow);
    }

    /** Shows rows that were added to the results, and the newest cells. */
    void update(List<CampaignCell> newCells) {
        if (!settingRows) {
            setNextRows();
        }
        if (newCells != cells) {
            cells = newCells;
            cellTable.setRows(cells.stream().map(results::cellRow).toList());
            filterRuns();
            histogram.update();
        }
        updateBars();
    }

    /** Says which runs show, if not all of them. */
    private void updateBars() {
        OptionalInt selected = cellTable.selectedIndex();
        if (selected.isEmpty()) {
            bars.forEach(bar -> bar.setVisible(false));
            return;
        }
        CampaignCell cell = cells.get(selected.getAsInt());
        String labels = results.cellRow(cell).stream()
                .limit(cell.labels().size())
                .map(ResultCell::text)
                .filter(Predicate.not(String::isEmpty))
                .collect(Collectors.joining(", "));
        bars.forEach(bar -> bar.showRow(labels, cell.runs().size(), results.size()));
    }

    private void showAllRuns() {
        cellTable.clearSelection();
        focusTable();
    }

    private void cellSelected(ListSelectionEvent event) {
        if (!event.getValueIsAdjusting()) {
            filterRuns();
            histogram.update();
            updateBars();
        }
    }

    private Collection<Long> selectedRuns() {
        return cellTable.selectedIndex().isPresent()
                ? cells.get(cellTable.selectedIndex().getAsInt()).runs()
                : results.runs();
    }

    /** Shows the runs of the selected cell. If some have been added, the other rows need not be sorted again. */
    private void filterRuns() {
        Set<Long> runs = cellTable.selectedIndex().isPresent() ? new HashSet<>(selectedRuns()) : null;
        if (Objects.equals(runs, shownRuns)) {
            return;
        }
        if (runs != null && shownRuns != null && runs.containsAll(shownRuns)) {
            runs.removeAll(shownRuns);
            shownRuns.addAll(runs);
            results.firstRow(runs).ifPresent(runTable::updateRows);
        } else {
            shownRuns = runs;
            runTable.showRows(runs == null ? row -> true : row -> runs.contains(results.run(row)));
        }
    }

    private void showRuns(int cell) {
        tabs.setSelectedIndex(firstTab + 1);
        focusTable();
        if (runTable.getRowCount() > 0) {
            runTable.setRowSelectionInterval(0, 0);
        }
    }
}
