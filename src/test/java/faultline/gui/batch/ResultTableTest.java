package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.AbstractList;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ResultTableTest {

    private final List<Integer> opened = new ArrayList<>();
    private ResultTable table;

    @BeforeEach
    void create() {
        table = callOnEdt(() -> new ResultTable("batch.tab.runs", List.of("outcome", "coverage"), opened::add));
        add("lost", "0.9");
        add("collided", "0.125");
        add("carried_on", "");
        add("lost", "0.5");
    }

    private void add(String outcome, String coverage) {
        runOnEdt(() -> table.addRows(
                List.of(List.of(ResultCell.of("outcome", outcome), ResultCell.of("coverage", coverage)))));
    }

    private List<String> column(int column) {
        return callOnEdt(() -> IntStream.range(0, table.getRowCount())
                .mapToObj(row -> String.valueOf(table.getValueAt(row, column)))
                .toList());
    }

    @Test
    void numbersAreSortedByValueAndNewRowsJoinTheOrder() {
        runOnEdt(() -> table.getRowSorter().toggleSortOrder(1));
        assertEquals(List.of("0.125", "0.5", "0.9", ""), column(1));
        add("lost", "0.25");
        assertEquals(List.of("0.125", "0.25", "0.5", "0.9", ""), column(1));
        assertEquals("collided", column(0).get(0));
        assertEquals("lost the wall", column(0).get(1));
    }

    @Test
    void allRowsCanBeSelectedToBeCopied() {
        runOnEdt(() -> table.getActionMap().get("menu A").actionPerformed(null));
        assertEquals(4, callOnEdt(table::getSelectedRowCount));
    }

    @Test
    void enterOpensTheSelectedRowWhateverTheOrder() {
        runOnEdt(() -> {
            table.getRowSorter().toggleSortOrder(1);
            table.setRowSelectionInterval(0, 0);
            SwingUtilities.notifyAction(
                    table.getActionMap().get("ENTER"),
                    KeyStroke.getKeyStroke("ENTER"),
                    new KeyEvent(table, 0, 0, 0, KeyEvent.VK_ENTER, '\n'),
                    table,
                    0);
        });
        assertEquals(List.of(1), opened);
    }

    @Test
    void theSelectionStaysWhileRowsAreReplacedAndHidden() {
        runOnEdt(() -> {
            table.getRowSorter().toggleSortOrder(1);
            table.setRowSelectionInterval(1, 1);
            table.setRows(List.of(row("a", "0.9"), row("b", "0.8"), row("c", "0.7"), row("d", "0.1"), row("e", "1")));
        });
        assertEquals(OptionalInt.of(3), callOnEdt(table::selectedIndex));
        runOnEdt(() -> table.showRows(row -> row > 2));
        assertEquals(List.of("d", "e"), column(0));
        assertEquals(OptionalInt.of(3), callOnEdt(table::selectedIndex));
    }

    @Test
    void rowsThatAreUpdatedJoinTheOrderWithoutAnotherSortOfAllRows() {
        runOnEdt(() -> {
            IntStream.range(4, 1000).forEach(i -> table.addRows(List.of(row("r" + i, Integer.toString(i % 7)))));
            table.getRowSorter().toggleSortOrder(1);
            Set<Integer> shown = new HashSet<>(IntStream.range(0, 990).boxed().toList());
            List<Integer> asked = new ArrayList<>();
            table.showRows(row -> {
                asked.add(row);
                return shown.contains(row);
            });
            asked.clear();
            shown.add(994);
            table.updateRows(990);
            assertEquals(Set.of(990, 991, 992, 993, 994, 995, 996, 997, 998, 999), Set.copyOf(asked));
            assertEquals(991, table.getRowCount());
            table.updateRows(1000);
        });
        // Before the empty one, which is the last of all.
        List<String> numbers = column(1).subList(0, 990);
        assertEquals(numbers.stream().sorted().toList(), numbers);
        assertTrue(column(0).contains("r994"));
    }

    private static List<ResultCell> row(String name, String number) {
        return List.of(ResultCell.ofText(name), ResultCell.of("coverage", number));
    }

    /** A row that counts how often it is asked for a cell. */
    private static final class CountingRow extends AbstractList<ResultCell> {
        private final int number;
        private int made;

        CountingRow(int number) {
            this.number = number;
        }

        @Override
        public ResultCell get(int index) {
            made++;
            return index == 0 ? ResultCell.ofText("r" + number) : ResultCell.of("coverage", "0." + number);
        }

        @Override
        public int size() {
            return 2;
        }
    }

    @Test
    void sortingMakesACellOfEachRowOnceAlsoOfRowsThatAreAddedOrReplaced() {
        List<CountingRow> rows = IntStream.range(1000, 3000)
                .map(i -> i * 7919 % 10_007 + 10_000)
                .mapToObj(CountingRow::new)
                .toList();
        runOnEdt(() -> {
            table.setRows(List.copyOf(rows.subList(0, 1000)));
            table.getRowSorter().toggleSortOrder(1);
            table.addRows(List.copyOf(rows.subList(1000, 2000)));
            table.setRows(500, List.copyOf(rows.subList(500, 600)));
        });
        // Two cells when a row is examined, which some are twice, one for the order, and those of the widths.
        int made = rows.stream().mapToInt(row -> row.made).sum();
        assertTrue(made < 7000, made + " cells");
        List<String> numbers = column(1);
        assertEquals(numbers.stream().sorted().toList(), numbers);
        runOnEdt(() -> {
            table.keepRows(700);
            table.addRows(List.copyOf(rows.subList(1500, 2000)));
        });
        assertEquals(1200, column(1).size());
        assertEquals(column(1).stream().sorted().toList(), column(1));
        assertEquals(
                column(0).stream().map(name -> name.substring(1)).toList(),
                column(1).stream().map(number -> number.substring(2)).toList());
    }

    private int headingAlignment(int column) {
        return callOnEdt(() -> ((JLabel) table.getColumnModel()
                        .getColumn(column)
                        .getHeaderRenderer()
                        .getTableCellRendererComponent(table, "", false, false, -1, column))
                .getHorizontalAlignment());
    }

    @Test
    void headingsStandWhereTheirColumnsDoAlsoBeforeThereAreRows() {
        List<String> columns = List.of("fault_sensor", "fault_value", "outcome");
        table = callOnEdt(() -> new ResultTable("batch.tab.runs", columns, opened::add));
        List<Integer> empty = List.of(headingAlignment(0), headingAlignment(1), headingAlignment(2));
        assertEquals(List.of(SwingConstants.LEADING, SwingConstants.TRAILING, SwingConstants.LEADING), empty);
        runOnEdt(() -> table.addRows(List.of(
                List.of(ResultCell.of("fault_sensor", "7"), ResultCell.ofText(""), ResultCell.of("outcome", "lost")))));
        for (int column = 0; column < columns.size(); column++) {
            assertEquals(empty.get(column), headingAlignment(column), columns.get(column));
            assertEquals(empty.get(column), cellAlignment(column), columns.get(column));
        }
    }

    @Test
    void aHeadingSaysWhatItsColumnMeans() {
        Rectangle heading = callOnEdt(() -> table.getTableHeader().getHeaderRect(0));
        MouseEvent over = new MouseEvent(
                table.getTableHeader(), MouseEvent.MOUSE_MOVED, 0, 0, heading.x + 5, heading.y + 5, 0, false);
        String tip = callOnEdt(() -> table.getTableHeader().getToolTipText(over));
        assertTrue(tip.contains("Undecided: the run is shorter than two laps"), tip);
    }

    private int cellAlignment(int column) {
        return callOnEdt(() ->
                ((JLabel) table.prepareRenderer(table.getCellRenderer(0, column), 0, column)).getHorizontalAlignment());
    }

    @Test
    void theReasonOfFailureTakesRoomOnlyWhenARunHasFailed() {
        table = callOnEdt(() -> new ResultTable("batch.tab.runs", List.of("run", "failure"), opened::add));
        runOnEdt(() -> table.addRows(List.of(List.of(ResultCell.of("run", "0"), ResultCell.of("failure", "")))));
        assertEquals(1, callOnEdt(table::getColumnCount));
        runOnEdt(() -> table.addRows(List.of(List.of(ResultCell.of("run", "1"), ResultCell.of("failure", "no file")))));
        assertEquals(List.of("", "no file"), column(1));
        assertEquals(
                "Reason for failure",
                callOnEdt(() -> table.getColumnModel().getColumn(1).getHeaderValue()));
    }

    @Test
    void aTableWithoutRoomBreaksItsHeadingsAndCutsTheHash() {
        table = callOnEdt(
                () -> new ResultTable("batch.tab.runs", List.of("fault_sensor", "trajectory_hash"), opened::add));
        String hash = "0123456789abcdef";
        runOnEdt(() -> table.addRows(
                List.of(List.of(ResultCell.ofText("front-right"), ResultCell.of("trajectory_hash", hash)))));
        int whole = callOnEdt(() -> table.getPreferredSize().width);
        int room = whole - 40;
        JScrollPane scroll = callOnEdt(() -> new JScrollPane(table));
        assertTrue(widthIn(scroll, room) <= room, "wider than " + room);
        assertEquals(hash, callOnEdt(() -> table.getValueAt(0, 1).toString()));
        Rectangle cell = callOnEdt(() -> table.getCellRect(0, 1, true));
        MouseEvent over = new MouseEvent(table, MouseEvent.MOUSE_MOVED, 0, 0, cell.x + 5, cell.y + 5, 0, false);
        assertEquals(hash, callOnEdt(() -> table.getToolTipText(over)));
        assertEquals(whole, widthIn(scroll, whole + 40), "there is room again");
    }

    private int widthIn(JScrollPane scroll, int room) {
        return callOnEdt(() -> {
            // The border of a scroll pane takes no room here.
            scroll.setBorder(null);
            scroll.setSize(room, 200);
            scroll.doLayout();
            scroll.getViewport().doLayout();
            return table.getPreferredSize().width;
        });
    }
}
