package faultline.gui.instrument;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.action.CopyableRows;
import faultline.gui.form.RowTable;
import faultline.gui.theme.FocusRing;
import faultline.gui.theme.KeyBindings;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import faultline.gui.timeline.EventGroup;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.GridLayout;
import java.awt.Insets;
import java.awt.Point;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.RowFilter;
import javax.swing.ScrollPaneConstants;
import javax.swing.table.TableColumn;
import javax.swing.table.TableRowSorter;

/**
 * The event log of a run. A double click or Enter on an event jumps to its time. The newest event stays in view unless
 * a row is selected. Check boxes choose the groups of events that show.
 */
public final class EventLogView extends JPanel {

    private static final int[] COLUMN_WIDTHS = {100, 130, 700};
    private static final int[] MIN_COLUMN_WIDTHS = {62, 98, 120};
    private static final int ROW_HEIGHT = 22;

    private final EventTableModel events = new EventTableModel();
    private final RowTable table = new RowTable(events);
    private final JScrollPane scroll = new JScrollPane(table);
    private final JScrollPane filter = createFilter();
    private final transient TableRowSorter<EventTableModel> rows = new TableRowSorter<>(events);
    private final transient Set<EventGroup> hidden = EnumSet.noneOf(EventGroup.class);

    /** Creates an empty log; {@code jump} receives the tick to go to. */
    public EventLogView(LongConsumer jump) {
        super(new BorderLayout());
        configureTable();
        table.onOpen(row ->
                jump.accept(events.eventAt(table.convertRowIndexToModel(row)).tick()));
        KeyBindings.bind(table, "ESCAPE", table::clearSelection);
        CopyableRows.install(table);
        scroll.setColumnHeaderView(table.getTableHeader());
        scroll.setBorder(new FocusRing.FocusBorder(false));
        add(filter, BorderLayout.LINE_END);
        add(scroll, BorderLayout.CENTER);
    }

    private JScrollPane createFilter() {
        JPanel boxes = new JPanel(new GridLayout(0, 1));
        Stream.of(EventGroup.values()).map(this::createBox).forEach(boxes::add);
        JPanel top = new JPanel(new BorderLayout());
        top.setBorder(BorderFactory.createEmptyBorder(2, 8, 2, 8));
        top.add(boxes, BorderLayout.NORTH);
        JScrollPane pane = ScreenFit.scrolling(top);
        pane.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        return pane;
    }

    private JCheckBox createBox(EventGroup group) {
        JCheckBox box = UiText.text(new JCheckBox("", true), "events.group." + group);
        box.addActionListener(event -> {
            if (box.isSelected()) {
                hidden.remove(group);
            } else {
                hidden.add(group);
            }
            filterRows();
        });
        return box;
    }

    private void filterRows() {
        // Without a filter, the sorter does nothing for new events.
        rows.setRowFilter(
                hidden.isEmpty()
                        ? null
                        : new RowFilter<>() {
                            @Override
                            public boolean include(Entry<? extends EventTableModel, ? extends Integer> entry) {
                                return !hidden.contains(EventGroup.of(events.eventAt(entry.getIdentifier())));
                            }
                        });
        scrollTo(table.getSelectedRow() < 0 ? table.getRowCount() - 1 : table.getSelectedRow());
    }

    private void scrollTo(int row) {
        // The viewport would convert the place of the row with the height that the table had before.
        scroll.validate();
        table.scrollRectToVisible(table.getCellRect(row, 0, true));
    }

    /**
     * Shows whole rows only; a row that is cut off at the bottom would look like a defect. The scroll bar of the filter
     * is beside its boxes.
     */
    @Override
    public void doLayout() {
        Dimension boxes = filter.getViewport().getView().getPreferredSize();
        boolean scrolled = boxes.height > getHeight();
        int bar = scrolled ? filter.getVerticalScrollBar().getPreferredSize().width : 0;
        filter.setPreferredSize(new Dimension(boxes.width + bar, boxes.height));
        super.doLayout();
        Insets border = scroll.getInsets();
        int outside = border.top + table.getTableHeader().getPreferredSize().height + border.bottom;
        int whole = (scroll.getHeight() - outside) / table.getRowHeight();
        if (whole > 0) {
            scroll.setSize(scroll.getWidth(), outside + whole * table.getRowHeight());
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(table.getBackground());
        graphics.fillRect(0, 0, getWidth(), getHeight());
    }

    private void configureTable() {
        UiText.tip(UiText.name(table, "events"), "events.tip");
        IntStream.range(0, events.getColumnCount()).forEach(column -> rows.setSortable(column, false));
        table.setRowSorter(rows);
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
            int min = TextSize.scaled(MIN_COLUMN_WIDTHS[i]);
            column.setMinWidth(
                    i == EventTableModel.KIND_COLUMN ? Math.max(min, EventCellRenderer.kindWidth(table)) : min);
            if (resized) {
                boolean last = i == COLUMN_WIDTHS.length - 1;
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

    /** Sets the contact of the reference run, null for none. */
    public void setGhostContact(RunEvent.GhostCollided contact) {
        assert EventQueue.isDispatchThread();
        events.setGhostContact(contact);
    }

    /** Shows a frame with the recording of its run. */
    public void setFrame(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        showRows(
                () -> events.update(frame.recording().events(), frame.snapshot().tick()));
    }

    /** Shows a frame, and adds lines that programs have printed. */
    void addLines(List<String> lines, SessionFrame frame) {
        setFrame(frame);
        showRows(() -> {
            events.addLines(lines, frame.snapshot().time());
            return true;
        });
    }

    /** Removes the events of the run and all lines. */
    void clear() {
        events.clear();
    }

    /** Makes a change that returns whether it added rows, and shows the newest row or those that showed before. */
    private void showRows(BooleanSupplier change) {
        int chosen = table.getSelectedRow();
        boolean added = change.getAsBoolean();
        if (table.getSelectedRow() >= 0) {
            scrollByRows(table.getSelectedRow() - chosen);
        } else if (added && table.getRowCount() > 0) {
            scrollTo(table.getRowCount() - 1);
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
