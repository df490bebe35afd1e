package faultline.gui.instrument;

import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.gui.text.Messages;
import faultline.gui.timeline.EventKind;
import faultline.gui.timeline.EventText;
import java.util.Objects;
import javax.swing.table.AbstractTableModel;

/** The event log as a table of time, kind and description. */
final class EventTableModel extends AbstractTableModel {

    /** The index of the kind column. */
    static final int KIND_COLUMN = 1;

    private static final String[] COLUMNS = {"events.time", "events.kind", "events.event"};

    private transient EventLog log = EventLog.EMPTY;
    /** The number of the oldest event that has a row. */
    private long firstEvent;

    /** Null if the run does not differ from the reference run. */
    private transient RunEvent.Diverged divergence;

    /** Inserts the divergence from the reference run among the events of the run; null removes it. */
    void setDivergence(RunEvent.Diverged newDivergence) {
        if (Objects.equals(newDivergence, divergence)) {
            return;
        }
        if (divergence != null) {
            int row = divergenceRow();
            divergence = null;
            fireTableRowsDeleted(row, row);
        }
        if (newDivergence != null) {
            divergence = newDivergence;
            fireTableRowsInserted(divergenceRow(), divergenceRow());
        }
    }

    /** Shows a newer log and returns whether rows were added. */
    boolean update(EventLog newest) {
        EventLog before = log;
        if (!isContinuation(before, newest)) {
            log = newest;
            firstEvent = newest.firstIndex();
            fireTableDataChanged();
            return true;
        }
        RunEvent.Diverged marked = divergence;
        if (marked != null && insertsBeforeDivergence(marked, before, newest)) {
            setDivergence(null);
        }
        removeOldest(newest.firstIndex());
        appendEvents(newest);
        setDivergence(marked);
        return newest.endIndex() > before.endIndex();
    }

    /** Returns whether a log belongs to the same run; another run has other event objects. */
    private static boolean isContinuation(EventLog before, EventLog newest) {
        if (before.endIndex() > newest.endIndex() || before.firstIndex() > newest.firstIndex()) {
            return false;
        }
        return before.endIndex() == before.firstIndex()
                ? newest.firstIndex() == before.firstIndex()
                : newest.firstIndex() < before.endIndex()
                        && before.get(newest.firstIndex()) == newest.get(newest.firstIndex());
    }

    /** Returns whether new events precede the divergence, which then moves to another row. */
    private static boolean insertsBeforeDivergence(RunEvent.Diverged divergence, EventLog before, EventLog newest) {
        return before.endIndex() < newest.endIndex()
                && newest.get(before.endIndex()).tick() < divergence.tick();
    }

    /**
     * Removes the rows of dropped events; the divergence keeps its row. With each notification, the table has exactly
     * the rows that are left, on which a sorter relies.
     */
    private void removeOldest(long newFirst) {
        long marked = firstEvent + divergenceRow();
        removeUntil(Math.min(newFirst, marked), 0);
        removeUntil(newFirst, 1);
    }

    /** Removes events before a new first one, given the row of the old one. */
    private void removeUntil(long newFirst, int row) {
        int removed = (int) (newFirst - firstEvent);
        firstEvent = newFirst;
        if (removed > 0) {
            fireTableRowsDeleted(row, row + removed - 1);
        }
    }

    private void appendEvents(EventLog newest) {
        int rows = getRowCount();
        log = newest;
        if (getRowCount() > rows) {
            fireTableRowsInserted(rows, getRowCount() - 1);
        }
    }

    RunEvent eventAt(int row) {
        int extra = divergenceRow();
        if (row == extra) {
            return divergence;
        }
        return log.get(firstEvent + (row < extra ? row : row - 1));
    }

    /** Returns the row of the divergence, after all events of earlier ticks; past the last row if there is none. */
    private int divergenceRow() {
        return divergence == null
                ? Integer.MAX_VALUE
                : (int) (Math.max(firstEvent, log.firstIndexSince(divergence.tick())) - firstEvent);
    }

    @Override
    public int getRowCount() {
        return (int) (log.endIndex() - firstEvent) + (divergence == null ? 0 : 1);
    }

    @Override
    public int getColumnCount() {
        return COLUMNS.length;
    }

    @Override
    public String getColumnName(int column) {
        return Messages.get(COLUMNS[column]);
    }

    @Override
    public String getValueAt(int row, int column) {
        RunEvent event = eventAt(row);
        return column == 0
                ? EventText.time(event)
                : column == KIND_COLUMN ? EventKind.of(event).text() : EventText.sentence(event);
    }
}
