package faultline.gui.instrument;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.panel.RowTable;
import faultline.gui.theme.FocusRing;
import faultline.gui.theme.KeyBindings;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Insets;
import java.awt.Point;
import java.util.function.LongConsumer;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.TableColumn;

/**
 * The event log of a run. A double click or Enter on an event jumps to its time. The newest event stays in view unless
 * a row is selected.
 */
public final class EventLogView extends JPanel {

    private static final int[] COLUMN_WIDTHS = {100, 130, 700};
    private static final int[] MIN_COLUMN_WIDTHS = {62, 98, 120};
    private static final int ROW_HEIGHT = 22;

    private final EventTableModel events = new EventTableModel();
    private final RowTable table = new RowTable(events);
    private final JScrollPane scroll = new JScrollPane(table);

    /** Creates an empty log; {@code jump} receives the tick to go to. */
    public EventLogView(LongConsumer jump) {
        super(new BorderLayout());
        configureTable();
        table.onOpen(row -> jump.accept(events.eventAt(row).tick()));
        KeyBindings.bind(table, "ESCAPE", table::clearSelection);
        scroll.setColumnHeaderView(table.getTableHeader());
        scroll.setBorder(new FocusRing.FocusBorder(false));
        add(scroll, BorderLayout.CENTER);
    }

    /** Shows whole rows only; a row that is cut off at the bottom would look like a defect. */
    @Override
    public void doLayout() {
        super.doLayout();
        Insets border = scroll.getInsets();
        int outside = border.top + table.getTableHeader().getPreferredSize().height + border.bottom;
        int rows = (getHeight() - outside) / table.getRowHeight();
        if (rows > 0) {
            scroll.setSize(getWidth(), outside + rows * table.getRowHeight());
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(table.getBackground());
        graphics.fillRect(0, 0, getWidth(), getHeight());
    }

    private void configureTable() {
        UiText.tip(UiText.name(table, "events"), "events.tip");
        table.setDefaultRenderer(Object.class, new EventCellRenderer(events));
        table.getTableHeader().setReorderingAllowed(false);
        RefreshSteps.add(table, self -> refreshTable());
    }

    /** Sets the headings, and with another text size the height of the rows and the initial widths of the columns. */
    private void refreshTable() {
        boolean resized = table.getRowHeight() != TextSize.scaled(ROW_HEIGHT);
        table.setRowHeight(TextSize.scaled(ROW_HEIGHT));
        for (int i = 0; i < COLUMN_WIDTHS.length; i++) {
            TableColumn column = table.getColumnModel().getColumn(i);
            column.setHeaderValue(events.getColumnName(i));
            if (resized) {
                boolean last = i == COLUMN_WIDTHS.length - 1;
                column.setMinWidth(TextSize.scaled(MIN_COLUMN_WIDTHS[i]));
                column.setMaxWidth(last ? Integer.MAX_VALUE : TextSize.scaled(2 * COLUMN_WIDTHS[i]));
                column.setPreferredWidth(TextSize.scaled(COLUMN_WIDTHS[i]));
            }
        }
        table.alignHeadings();
    }

    /** Shows the moment at which the run differs from the reference run, null for never. */
    public void setDivergence(RunEvent.Diverged divergence) {
        assert EventQueue.isDispatchThread();
        events.setDivergence(divergence);
    }

    /** Shows a frame with the recording of its run. */
    public void setFrame(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        int chosen = table.getSelectedRow();
        boolean added = events.update(frame.recording().events());
        if (table.getSelectedRow() >= 0) {
            scrollByRows(table.getSelectedRow() - chosen);
        } else if (added && table.getRowCount() > 0) {
            table.scrollRectToVisible(table.getCellRect(table.getRowCount() - 1, 0, true));
        }
    }

    /** Keeps the visible rows in place when the oldest events are dropped. */
    private void scrollByRows(int rows) {
        if (rows != 0) {
            Point top = scroll.getViewport().getViewPosition();
            scroll.getViewport().setViewPosition(new Point(top.x, Math.max(0, top.y + rows * table.getRowHeight())));
        }
    }

    JTable table() {
        return table;
    }
}
