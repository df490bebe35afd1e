package faultline.gui.instrument;

import faultline.engine.recording.RunEvent;
import faultline.gui.theme.GlyphIcon;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.ThemeColours;
import faultline.gui.timeline.EventKind;
import java.awt.Color;
import java.awt.Component;
import java.awt.FontMetrics;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JLabel;
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

    /** Returns the width of the widest kind of event in a table, with its mark, pixels. */
    static int kindWidth(JTable table) {
        FontMetrics metrics = table.getFontMetrics(table.getFont());
        int text = Stream.of(EventKind.values())
                .mapToInt(kind -> metrics.stringWidth(kind.text()))
                .max()
                .orElse(0);
        return text
                + 2 * SIDE_PADDING
                + TextSize.scaled(ICON_SIZE)
                + new JLabel().getIconTextGap()
                + table.getIntercellSpacing().width;
    }

    private static Icon icon(RunEvent event, boolean selected) {
        EventKind kind = EventKind.of(event);
        Function<ThemeColours, Color> colour = kind.isWarning() ? ThemeColours::warning : ThemeColours::muted;
        return new GlyphIcon(kind.mark(), TextSize.scaled(ICON_SIZE), selected ? null : colour);
    }
}
