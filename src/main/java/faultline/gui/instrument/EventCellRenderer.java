package faultline.gui.instrument;

import faultline.engine.recording.RunEvent;
import faultline.gui.theme.GlyphIcon;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.ThemeColours;
import faultline.gui.timeline.EventKind;
import java.awt.Color;
import java.awt.Component;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;

/** Renders the cells of the event log with padding, and with a mark for the kind of each event. */
final class EventCellRenderer extends DefaultTableCellRenderer {

    private static final int SIDE_PADDING = 6;
    private static final int ICON_SIZE = 14;

    private final transient EventTableModel events;

    EventCellRenderer(EventTableModel events) {
        this.events = events;
    }

    @Override
    public Component getTableCellRendererComponent(
            JTable table, Object value, boolean selected, boolean focused, int row, int column) {
        super.getTableCellRendererComponent(table, value, selected, focused, row, column);
        setBorder(BorderFactory.createEmptyBorder(0, SIDE_PADDING, 0, SIDE_PADDING));
        setIcon(
                column == EventTableModel.KIND_COLUMN
                        ? icon(events.eventAt(table.convertRowIndexToModel(row)), selected)
                        : null);
        return this;
    }

    private static Icon icon(RunEvent event, boolean selected) {
        EventKind kind = EventKind.of(event);
        Function<ThemeColours, Color> colour = kind.isWarning() ? ThemeColours::warning : ThemeColours::muted;
        return new GlyphIcon(kind.mark(), TextSize.scaled(ICON_SIZE), selected ? null : colour);
    }
}
