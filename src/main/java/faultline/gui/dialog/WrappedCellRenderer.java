package faultline.gui.dialog;

import java.awt.Component;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.BorderFactory;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.table.TableCellRenderer;

/** Wraps the texts of a table's cells. */
final class WrappedCellRenderer extends JTextArea implements TableCellRenderer {

    private WrappedCellRenderer() {
        setLineWrap(true);
        setWrapStyleWord(true);
        setBorder(BorderFactory.createEmptyBorder(5, 6, 5, 6));
    }

    /**
     * Gives columns at least the given widths, in pixels, and the width of their headings, and rows the height of their
     * texts. Returns the renderer, which fits the rows again when they change.
     */
    static WrappedCellRenderer install(JTable table, List<Integer> minWidths) {
        List<Integer> widths = IntStream.range(0, minWidths.size())
                .mapToObj(column -> Math.max(minWidths.get(column), headingWidth(table, column)))
                .toList();
        WrappedCellRenderer cells = new WrappedCellRenderer();
        table.setDefaultRenderer(Object.class, cells);
        for (int column = 0; column < widths.size(); column++) {
            table.getColumnModel().getColumn(column).setPreferredWidth(widths.get(column));
            table.getColumnModel().getColumn(column).setWidth(widths.get(column));
        }
        cells.fitRows(table);
        table.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                cells.fitRows(table);
            }
        });
        return cells;
    }

    /** Gives each row the height that its texts need in the present columns. */
    void fitRows(JTable table) {
        for (int row = 0; row < table.getRowCount(); row++) {
            int height = 0;
            for (int column = 0; column < table.getColumnCount(); column++) {
                setSize(table.getColumnModel().getColumn(column).getWidth(), Short.MAX_VALUE);
                setText(String.valueOf(table.getValueAt(row, column)));
                height = Math.max(height, getPreferredSize().height);
            }
            if (height != table.getRowHeight(row)) {
                table.setRowHeight(row, height);
            }
        }
    }

    /** Returns the preferred width of a column's heading, pixels. */
    private static int headingWidth(JTable table, int column) {
        return table.getTableHeader()
                .getDefaultRenderer()
                .getTableCellRendererComponent(table, table.getColumnName(column), false, false, -1, column)
                .getPreferredSize()
                .width;
    }

    @Override
    public Component getTableCellRendererComponent(
            JTable table, Object value, boolean selected, boolean focused, int row, int column) {
        setText(String.valueOf(value));
        setForeground(selected ? table.getSelectionForeground() : table.getForeground());
        setBackground(selected ? table.getSelectionBackground() : table.getBackground());
        return this;
    }
}
