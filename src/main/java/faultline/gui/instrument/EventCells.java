package faultline.gui.instrument;

import faultline.engine.record.RunEvent;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import java.awt.Component;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;

/** The cells of the event log: with room at the sides, and a sign before what went wrong. */
final class EventCells extends DefaultTableCellRenderer {

    private static final int SIDE = 6;
    private static final int SIGN = 14;

    private final transient EventTable events;
    private final transient Icon warning = new GlyphIcon(Glyph.WARNING, SIGN, colours -> Optional.of(colours.warning()));
    private final transient Icon refusal = new GlyphIcon(Glyph.REMOVE, SIGN, colours -> Optional.of(colours.warning()));
    private final transient Icon done = new GlyphIcon(Glyph.NOTE, SIGN, colours -> Optional.of(colours.muted()));
    private final transient Icon arrow = new GlyphIcon(Glyph.RUN, SIGN, colours -> Optional.of(colours.muted()));

    EventCells(EventTable events) {
        this.events = events;
    }

    @Override
    public Component getTableCellRendererComponent(JTable table, Object value, boolean selected, boolean focused, int row, int column) {
        super.getTableCellRendererComponent(table, value, selected, focused, row, column);
        setBorder(BorderFactory.createEmptyBorder(0, SIDE, 0, SIDE));
        setIcon(column == EventTable.KIND ? sign(events.event(row)) : null);
        return this;
    }

    private Icon sign(RunEvent event) {
        if (event instanceof RunEvent.Refused) {
            return refusal;
        }
        if (event instanceof RunEvent.Transition) {
            return arrow;
        }
        return EventText.isWrong(event) ? warning : done;
    }
}
