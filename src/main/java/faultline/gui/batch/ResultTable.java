package faultline.gui.batch;

import faultline.gui.action.CopyableRows;
import faultline.gui.form.RowTable;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.HierarchyBoundsAdapter;
import java.awt.event.HierarchyEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.IntConsumer;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JViewport;
import javax.swing.RowFilter;
import javax.swing.RowSorter;
import javax.swing.SwingConstants;
import javax.swing.border.Border;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import javax.swing.table.TableRowSorter;

/** A sortable table of results, which grows while they are made. A double click or Enter opens a row. */
final class ResultTable extends RowTable {

    private static final int ROW_HEIGHT = 22;
    private static final int MAX_SAMPLED_ROWS = 40;
    private static final int CELL_PADDING = 6;
    private static final int MAX_COLUMN_WIDTH = 260;
    /** The widest hash of a table that lacks room. Its tool tip shows the whole text. */
    private static final int SHORT_HASH_WIDTH = 90;

    private static final String HASH = "trajectory_hash";

    /** The columns of what does not happen in every batch. They take no room before. */
    private static final Set<String> OCCASIONAL = Set.of("collision_time_s", "detection_delay_s", "failure");

    /** The end of the name of the column of the ends of faults, which not every fault has. */
    private static final String FAULT_END = "_end_s";

    /** The columns of texts before there are any; all others with texts and no numbers are columns of texts, too. */
    private static final Set<String> TEXTS =
            Set.of("world", "fault_kind", "fault_sensor", "controller_diagnosis", "outcome", HASH, "failure");

    private final Model model;
    private final transient TableRowSorter<Model> sorter;
    /** The columns without a value in any run, which are not shown. */
    private final transient List<TableColumn> hidden = new ArrayList<>();
    /** Whether headings are broken into lines and the hash is cut, because the table lacks room. */
    private boolean compact;

    /** The rows of a table. */
    private static final class Model extends AbstractTableModel {
        private final List<String> columns;
        /** The rows, which may make a cell each time when it is asked for. */
        private final List<List<ResultCell>> rows = new ArrayList<>();
        /** The cells of the columns by which the rows are sorted, each of which is compared many times. */
        private final Map<Integer, List<ResultCell>> sorted = new HashMap<>();
        /** The columns that have a value. */
        private final BitSet filled = new BitSet();
        /** The columns that have a number. */
        private final BitSet numeric = new BitSet();
        /** The columns that have a text other than the sign for no value. */
        private final BitSet textual = new BitSet();

        Model(List<String> columns) {
            this.columns = List.copyOf(columns);
        }

        void sortBy(Set<Integer> sortColumns) {
            sorted.keySet().retainAll(sortColumns);
            for (int column : sortColumns) {
                sorted.computeIfAbsent(column, added -> new ArrayList<>(cells(rows, added)));
            }
        }

        private static List<ResultCell> cells(List<List<ResultCell>> rows, int column) {
            return rows.stream().map(row -> row.get(column)).toList();
        }

        void add(List<List<ResultCell>> added) {
            added.forEach(this::examine);
            rows.addAll(added);
            sorted.forEach((column, cells) -> cells.addAll(cells(added, column)));
        }

        void set(int index, List<ResultCell> row) {
            examine(row);
            rows.set(index, row);
            sorted.forEach((column, cells) -> cells.set(index, row.get(column)));
        }

        void keep(int count) {
            rows.subList(count, rows.size()).clear();
            sorted.values().forEach(cells -> cells.subList(count, cells.size()).clear());
        }

        private void examine(List<ResultCell> row) {
            for (int column = 0; column < row.size(); column++) {
                ResultCell cell = row.get(column);
                if (cell.isNumber()) {
                    numeric.set(column);
                } else if (!cell.text().isEmpty() && !cell.text().equals(ResultCell.NONE)) {
                    textual.set(column);
                }
                if (!cell.text().isEmpty()) {
                    filled.set(column);
                }
            }
        }

        @Override
        public int getRowCount() {
            return rows.size();
        }

        @Override
        public int getColumnCount() {
            return columns.size();
        }

        @Override
        public String getColumnName(int column) {
            return title(columns.get(column));
        }

        @Override
        public Class<?> getColumnClass(int column) {
            return ResultCell.class;
        }

        @Override
        public Object getValueAt(int row, int column) {
            List<ResultCell> known = sorted.get(column);
            return known == null ? rows.get(row).get(column) : known.get(row);
        }
    }

    /**
     * Creates an empty table of columns of {@code runs.csv}. The key is that of the accessible name; {@code onOpen}
     * receives the index of a row in the order in which rows were added.
     */
    ResultTable(String key, List<String> columns, IntConsumer onOpen) {
        super(new Model(columns));
        model = (Model) getModel();
        sorter = new TableRowSorter<>(model);
        sorter.setSortsOnUpdates(true);
        // This is called before the rows are sorted.
        sorter.addRowSorterListener(event -> model.sortBy(
                sorter.getSortKeys().stream().map(RowSorter.SortKey::getColumn).collect(Collectors.toSet())));
        setRowSorter(sorter);
        UiText.tip(UiText.name(this, key), key + ".tip");
        setDefaultRenderer(ResultCell.class, new Renderer());
        setIntercellSpacing(new Dimension(0, 1));
        setAutoResizeMode(AUTO_RESIZE_OFF);
        onOpen(row -> onOpen.accept(convertRowIndexToModel(row)));
        CopyableRows.install(this);
        setHeadingRenderers();
        for (int column = 0; column < columns.size(); column++) {
            if (OCCASIONAL.contains(columns.get(column)) || columns.get(column).endsWith(FAULT_END)) {
                hidden.add(getColumnModel().getColumn(column));
            }
        }
        hidden.forEach(this::removeColumn);
        addHierarchyBoundsListener(new HierarchyBoundsAdapter() {
            @Override
            public void ancestorResized(HierarchyEvent event) {
                fitColumns();
            }
        });
        RefreshSteps.add(this, ResultTable::refresh);
    }

    /** Headings of numbers stand at the end of their column, as the numbers do, also before there are any. */
    private void setHeadingRenderers() {
        TableCellRenderer headings = (table, value, selected, focused, row, column) -> {
            boolean textual = isTextual(column);
            Component heading = getTableHeader()
                    .getDefaultRenderer()
                    .getTableCellRendererComponent(
                            table, headingText(String.valueOf(value), textual), selected, focused, row, column);
            if (heading instanceof JLabel label) {
                label.setHorizontalAlignment(alignment(column));
                label.setToolTipText(tip(model.columns.get(convertColumnIndexToModel(column))));
            }
            return heading;
        };
        if (getTableHeader().getDefaultRenderer() instanceof JLabel label) {
            label.putClientProperty("html.disable", false);
        }
        for (int column = 0; column < getColumnCount(); column++) {
            getColumnModel().getColumn(column).setHeaderRenderer(headings);
        }
    }

    private boolean isTextual(int column) {
        int index = convertColumnIndexToModel(column);
        return TEXTS.contains(model.columns.get(index)) || model.textual.get(index) && !model.numeric.get(index);
    }

    private int alignment(int column) {
        return isTextual(column) ? SwingConstants.LEADING : SwingConstants.TRAILING;
    }

    private String headingText(String name, boolean textual) {
        return compact
                ? "<html><div align=" + (textual ? "left" : "right") + ">" + name.replaceFirst(" ", "<br>")
                : name;
    }

    private void refresh() {
        setRowHeight(TextSize.scaled(ROW_HEIGHT));
        alignHeadings();
        for (int column = 0; column < getColumnCount(); column++) {
            TableColumn shown = getColumnModel().getColumn(column);
            shown.setHeaderValue(model.getColumnName(shown.getModelIndex()));
        }
        fitColumns();
    }

    private static String title(String column) {
        String key = "batch.column." + column;
        return Messages.contains(key) ? Messages.get(key) : column.replace('_', ' ');
    }

    /** Returns what a column means, null if its title says enough. */
    private static String tip(String column) {
        String key = "batch.column." + column + ".tip";
        return Messages.contains(key) ? Messages.get(key) : null;
    }

    /** Returns the index of the selected row, in the order in which rows were added. */
    OptionalInt selectedIndex() {
        int row = getSelectedRow();
        return row < 0 ? OptionalInt.empty() : OptionalInt.of(convertRowIndexToModel(row));
    }

    /** Returns the number of rows, also of those that are not shown. */
    int allRowCount() {
        return model.rows.size();
    }

    /** Adds rows at the end. */
    void addRows(List<List<ResultCell>> rows) {
        if (!rows.isEmpty()) {
            int first = model.rows.size();
            model.add(rows);
            showFilledColumns();
            model.fireTableRowsInserted(first, model.rows.size() - 1);
            if (first < MAX_SAMPLED_ROWS) {
                fitColumns();
            }
        }
    }

    private void showFilledColumns() {
        for (TableColumn column : List.copyOf(hidden)) {
            if (model.filled.get(column.getModelIndex())) {
                hidden.remove(column);
                column.setHeaderValue(model.getColumnName(column.getModelIndex()));
                long before = IntStream.range(0, getColumnCount())
                        .filter(shown -> convertColumnIndexToModel(shown) < column.getModelIndex())
                        .count();
                addColumn(column);
                moveColumn(getColumnCount() - 1, (int) before);
                fitColumns();
            }
        }
    }

    /** Replaces all rows; the selection stays. */
    void setRows(List<List<ResultCell>> rows) {
        keepRows(Math.min(rows.size(), allRowCount()));
        setRows(0, rows);
    }

    /** Sets the rows from an index on, which may be the number of rows, and leaves those behind them as they are. */
    void setRows(int first, List<List<ResultCell>> rows) {
        int known = Math.min(rows.size(), allRowCount() - first);
        if (known > 0) {
            for (int i = 0; i < known; i++) {
                model.set(first + i, rows.get(i));
            }
            model.fireTableRowsUpdated(first, first + known - 1);
        }
        addRows(rows.subList(known, rows.size()));
    }

    /** Removes all rows but the first ones. */
    void keepRows(int count) {
        int before = allRowCount();
        if (count < before) {
            model.keep(count);
            model.fireTableRowsDeleted(count, before - 1);
        }
    }

    /** Shows only some rows, given by their indices in the order in which they were added. */
    void showRows(IntPredicate shown) {
        sorter.setRowFilter(new RowFilter<>() {
            @Override
            public boolean include(Entry<? extends Model, ? extends Integer> entry) {
                return shown.test(entry.getIdentifier());
            }
        });
    }

    /** Shows or hides the rows from an index on, by what has been set to show them, which has changed since. */
    void updateRows(int first) {
        if (first < model.rows.size()) {
            model.fireTableRowsUpdated(first, model.rows.size() - 1);
        }
    }

    /** Makes each column as wide as its heading and its first rows, and narrower if all together lack room. */
    private void fitColumns() {
        boolean before = compact;
        compact = false;
        fitWidths();
        compact = getParent() instanceof JViewport viewport
                && viewport.getWidth() > 0
                && getColumnModel().getTotalColumnWidth() > viewport.getWidth();
        if (compact) {
            fitWidths();
        }
        if (compact != before) {
            getTableHeader().resizeAndRepaint();
        }
    }

    private void fitWidths() {
        for (int column = 0; column < getColumnCount(); column++) {
            TableColumn shown = getColumnModel().getColumn(column);
            int width = width(shown.getHeaderRenderer()
                    .getTableCellRendererComponent(this, getColumnName(column), false, false, -1, column));
            int cells = 0;
            for (int row = 0; row < Math.min(MAX_SAMPLED_ROWS, model.getRowCount()); row++) {
                Component cell = getDefaultRenderer(ResultCell.class)
                        .getTableCellRendererComponent(
                                this, model.getValueAt(row, shown.getModelIndex()), false, false, row, column);
                cells = Math.max(cells, width(cell));
            }
            width = Math.max(
                    width, Math.min(cells, TextSize.scaled(isCut(shown) ? SHORT_HASH_WIDTH : MAX_COLUMN_WIDTH)));
            shown.setPreferredWidth(Math.min(TextSize.scaled(MAX_COLUMN_WIDTH), width));
            shown.setWidth(shown.getPreferredWidth());
        }
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        int row = rowAtPoint(event.getPoint());
        int column = columnAtPoint(event.getPoint());
        return row >= 0 && column >= 0 && isCut(getColumnModel().getColumn(column))
                ? String.valueOf(getValueAt(row, column))
                : super.getToolTipText(event);
    }

    private boolean isCut(TableColumn column) {
        return compact && model.columns.get(column.getModelIndex()).equals(HASH);
    }

    private int width(Component cell) {
        return cell.getPreferredSize().width + (compact ? 1 : TextSize.scaled(CELL_PADDING));
    }

    /** Fills the width of a wide window, and scrolls in a narrow one. */
    @Override
    public boolean getScrollableTracksViewportWidth() {
        return getPreferredSize().width < getParent().getWidth();
    }

    /** Numbers stand at the end of their column. */
    private final class Renderer extends DefaultTableCellRenderer {
        private static final Border PADDING = BorderFactory.createEmptyBorder(0, 6, 0, 6);

        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean selected, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, selected, focused, row, column);
            setBorder(PADDING);
            setHorizontalAlignment(alignment(column));
            return this;
        }
    }
}
