package faultline.gui.instrument;

import faultline.engine.recording.RunEvent;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.gui.timeline.EventText;
import java.awt.Component;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;

/** Renders the cells of the event log with padding, and with an icon for failures. */
final class EventCellRenderer extends DefaultTableCellRenderer {

    private static final int SIDE_PADDING = 6;
    private static final int ICON_SIZE = 14;

    private final transient EventTableModel events;
    private final transient Icon warning = new GlyphIcon(Glyph.WARNING, ICON_SIZE, colours -> colours.warning());
    private final transient Icon refusal = new GlyphIcon(Glyph.REMOVE, ICON_SIZE, colours -> colours.warning());
    private final transient Icon done = new GlyphIcon(Glyph.NOTE, ICON_SIZE, colours -> colours.muted());
    private final transient Icon arrow = new GlyphIcon(Glyph.RUN, ICON_SIZE, colours -> colours.muted());

    EventCellRenderer(EventTableModel events) {
        this.events = events;
    }

    @Override
    public Component getTableCellRendererComponent(
            JTable table, Object value, boolean selected, boolean focused, int row, int column) {
        super.getTableCellRendererComponent(table, value, selected, focused, row, column);
        setBorder(BorderFactory.createEmptyBorder(0, SIDE_PADDING, 0, SIDE_PADDING));
        setIcon(column == EventTableModel.KIND_COLUMN ? iconFor(events.eventAt(row)) : null);
        return this;
    }

    private Icon iconFor(RunEvent event) {
        if (event instanceof RunEvent.CommandRefused) {
            return refusal;
        }
        if (event instanceof RunEvent.StateChanged) {
            return arrow;
        }
        return EventText.isFailure(event) ? warning : done;
    }
}
