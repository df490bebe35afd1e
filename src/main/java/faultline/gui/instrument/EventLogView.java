package faultline.gui.instrument;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.LongConsumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.table.TableColumn;

/**
 * The event log of a run. A double click or Enter on an event jumps to its time. The newest event stays in view unless
 * a row is selected.
 */
public final class EventLogView extends JPanel {

    private static final int[] COLUMN_WIDTHS = {100, 130, 700};
    private static final int[] MIN_COLUMN_WIDTHS = {62, 98, 120};
    private static final int ROW_HEIGHT = 22;
    private static final String JUMP_ACTION = "jump";

    private final EventTableModel events = new EventTableModel();
    private final JTable table = new JTable(events);
    private final JScrollPane scroll = new JScrollPane(table);
    private final transient LongConsumer seekHandler;

    /**
     * Creates an empty log.
     *
     * @param jump receives the tick to go to
     */
    public EventLogView(LongConsumer jump) {
        super(new BorderLayout());
        this.seekHandler = jump;
        configureTable();
        installListeners();
        scroll.setColumnHeaderView(table.getTableHeader());
        scroll.setBorder(BorderFactory.createEmptyBorder());
        add(scroll, BorderLayout.CENTER);
    }

    /** Shows whole rows only; half a row at the bottom would look like a defect. */
    @Override
    public void doLayout() {
        super.doLayout();
        int headings = table.getTableHeader().getPreferredSize().height;
        int rows = (getHeight() - headings) / table.getRowHeight();
        if (rows > 0) {
            scroll.setSize(getWidth(), headings + rows * table.getRowHeight());
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(table.getBackground());
        graphics.fillRect(0, 0, getWidth(), getHeight());
    }

    private void configureTable() {
        UiText.tip(UiText.name(table, "events"), "events.tip");
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.setDefaultRenderer(Object.class, new EventCellRenderer(events));
        table.setShowVerticalLines(false);
        table.setFillsViewportHeight(true);
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
        if (table.getTableHeader().getDefaultRenderer() instanceof JLabel headings) {
            headings.setHorizontalAlignment(SwingConstants.LEADING);
        }
    }

    private void installListeners() {
        table.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                if (event.getClickCount() == 2) {
                    seekToRow(table.rowAtPoint(event.getPoint()));
                }
            }
        });
        bindKey("ENTER", JUMP_ACTION, () -> seekToRow(table.getSelectedRow()));
        bindKey("ESCAPE", "release", table::clearSelection);
    }

    private void bindKey(String key, String name, Runnable action) {
        table.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key), name);
        table.getActionMap().put(name, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    private void seekToRow(int row) {
        if (row >= 0) {
            seekHandler.accept(events.eventAt(row).tick());
        }
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
