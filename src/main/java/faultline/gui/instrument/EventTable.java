package faultline.gui.instrument;

import faultline.engine.record.EventLog;
import faultline.engine.record.RunEvent;
import faultline.gui.text.Texts;
import java.util.Optional;
import javax.swing.table.AbstractTableModel;

/** The event log as rows: time, kind, and what happened. */
final class EventTable extends AbstractTableModel {

    /** The column of the kinds. */
    static final int KIND = 1;

    private static final String[] COLUMNS = {"events.time", "events.kind", "events.what"};

    private transient EventLog log = EventLog.EMPTY;
    private transient Optional<RunEvent.Diverged> divergence = Optional.empty();

    /** Shows, from now on, where the run became another than an earlier one, among the events of the run itself. */
    void mark(Optional<RunEvent.Diverged> newDivergence) {
        if (!newDivergence.equals(divergence)) {
            divergence = newDivergence;
            fireTableDataChanged();
        }
    }

    /** Shows a newer log; true where rows were added. */
    boolean show(EventLog newest) {
        EventLog before = log;
        int rows = getRowCount();
        int rowOfDivergence = rowOfDivergence();
        log = newest;
        boolean continues = rowOfDivergence == rowOfDivergence() && before.first() == newest.first() && before.end() <= newest.end()
                && startsAlike(before, newest);
        if (!continues) {
            fireTableDataChanged();
        } else if (getRowCount() > rows) {
            fireTableRowsInserted(rows, getRowCount() - 1);
        }
        return !continues || getRowCount() > rows;
    }

    /** Another run's events are other objects. */
    private static boolean startsAlike(EventLog before, EventLog newest) {
        return before.end() == before.first() || before.get(before.first()) == newest.get(newest.first());
    }

    RunEvent event(int row) {
        int extra = rowOfDivergence();
        if (row == extra) {
            return divergence.orElseThrow();
        }
        return log.get(log.first() + (row < extra ? row : row - 1));
    }

    /** After all events of earlier ticks; beyond the last row where there is none. */
    private int rowOfDivergence() {
        return divergence.map(event -> (int) (log.since(event.tick()) - log.first())).orElse(Integer.MAX_VALUE);
    }

    @Override
    public int getRowCount() {
        return (int) (log.end() - log.first()) + (divergence.isPresent() ? 1 : 0);
    }

    @Override
    public int getColumnCount() {
        return COLUMNS.length;
    }

    @Override
    public String getColumnName(int column) {
        return Texts.text(COLUMNS[column]);
    }

    @Override
    public String getValueAt(int row, int column) {
        RunEvent event = event(row);
        return column == 0 ? EventText.time(event) : column == KIND ? EventText.kind(event) : EventText.sentence(event);
    }
}
