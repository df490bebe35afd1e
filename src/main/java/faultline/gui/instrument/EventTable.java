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
    /** The oldest event that has a row. */
    private long first;
    private transient Optional<RunEvent.Diverged> divergence = Optional.empty();

    /** Shows, from now on, where the run became another than an earlier one, among the events of the run itself. */
    void mark(Optional<RunEvent.Diverged> newDivergence) {
        if (newDivergence.equals(divergence)) {
            return;
        }
        if (divergence.isPresent()) {
            int row = rowOfDivergence();
            divergence = Optional.empty();
            fireTableRowsDeleted(row, row);
        }
        if (newDivergence.isPresent()) {
            divergence = newDivergence;
            fireTableRowsInserted(rowOfDivergence(), rowOfDivergence());
        }
    }

    /** Shows a newer log; true where rows were added. */
    boolean show(EventLog newest) {
        EventLog before = log;
        if (!continues(before, newest)) {
            log = newest;
            first = newest.first();
            fireTableDataChanged();
            return true;
        }
        Optional<RunEvent.Diverged> marked = divergence;
        if (marked.isPresent() && goesOnBeforeIt(marked.get(), before, newest)) {
            mark(Optional.empty());
        }
        forget(newest.first());
        append(newest);
        mark(marked);
        return newest.end() > before.end();
    }

    /** Whether a log is of the same run: another run's events are other objects. */
    private static boolean continues(EventLog before, EventLog newest) {
        if (before.end() > newest.end() || before.first() > newest.first()) {
            return false;
        }
        return before.end() == before.first() ? newest.first() == before.first()
                : newest.first() < before.end() && before.get(newest.first()) == newest.get(newest.first());
    }

    /** Whether events are new that happened before the divergence, which then no longer stands where it stood. */
    private static boolean goesOnBeforeIt(RunEvent.Diverged divergence, EventLog before, EventLog newest) {
        return before.end() < newest.end() && newest.get(before.end()).tick() < divergence.tick();
    }

    /** The oldest events are forgotten, and the divergence is not. */
    private void forget(long newFirst) {
        int forgotten = (int) (newFirst - first);
        int marked = rowOfDivergence();
        first = newFirst;
        if (forgotten > marked) {
            fireTableRowsDeleted(marked + 1, forgotten);
        }
        int above = Math.min(forgotten, marked);
        if (above > 0) {
            fireTableRowsDeleted(0, above - 1);
        }
    }

    private void append(EventLog newest) {
        int rows = getRowCount();
        log = newest;
        if (getRowCount() > rows) {
            fireTableRowsInserted(rows, getRowCount() - 1);
        }
    }

    RunEvent event(int row) {
        int extra = rowOfDivergence();
        if (row == extra) {
            return divergence.orElseThrow();
        }
        return log.get(first + (row < extra ? row : row - 1));
    }

    /** After all events of earlier ticks; beyond the last row where there is none. */
    private int rowOfDivergence() {
        return divergence.map(event -> (int) (Math.max(first, log.since(event.tick())) - first)).orElse(Integer.MAX_VALUE);
    }

    @Override
    public int getRowCount() {
        return (int) (log.end() - first) + (divergence.isPresent() ? 1 : 0);
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
