package faultline.gui.instrument;

import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.gui.text.Messages;
import faultline.gui.timeline.EventKind;
import faultline.gui.timeline.EventText;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import javax.swing.table.AbstractTableModel;

/**
 * The event log as a table of time, kind and description. The divergence from the reference run, its contact, and what
 * controller programs have printed are listed among the events of the log.
 */
final class EventTableModel extends AbstractTableModel {

    /** The index of the kind column. */
    static final int KIND_COLUMN = 1;

    /** The maximum number of printed lines; the events of a log are many times as many. */
    static final int MAX_LINES = 300;

    private static final String[] COLUMNS = {"events.time", "events.kind", "events.event"};

    private transient EventLog log = EventLog.EMPTY;
    /** The number of the oldest event that has a row. */
    private long firstEvent;
    /** The newest tick that is shown. */
    private long tick;

    /** The events that are not part of the log, in the order of their ticks and rows. */
    private final transient List<Extra> extras = new ArrayList<>();
    /** Null if the run does not differ from the reference run. */
    private transient RunEvent.Diverged divergence;
    /** Null if there is no reference run with a contact. */
    private transient RunEvent.GhostCollided ghostContact;

    /** An event that is not part of the log, and the number of the event in the log before which it is listed. */
    private record Extra(long next, RunEvent event) {
        boolean isLine() {
            return event instanceof RunEvent.Printed;
        }
    }

    /** Inserts the divergence from the reference run among the events of the run; null removes it. */
    void setDivergence(RunEvent.Diverged newDivergence) {
        if (Objects.equals(newDivergence, divergence)) {
            return;
        }
        removeExtra(divergence);
        divergence = newDivergence;
        if (newDivergence != null) {
            insertExtra(newDivergence);
        }
    }

    /** Sets the contact of the reference run, which is listed when the run has reached its tick; null for none. */
    void setGhostContact(RunEvent.GhostCollided newContact) {
        if (!Objects.equals(newContact, ghostContact)) {
            removeExtra(ghostContact);
            ghostContact = newContact;
            listGhostContact();
        }
    }

    private void listGhostContact() {
        if (ghostContact != null && ghostContact.tick() <= tick && placeOf(ghostContact) < 0) {
            insertExtra(ghostContact);
        }
    }

    private void insertExtra(RunEvent event) {
        insertExtras(extrasBefore(event.tick()), log.firstIndexSince(event.tick()), List.of(event));
    }

    private void removeExtra(RunEvent event) {
        int place = placeOf(event);
        if (place >= 0) {
            removeExtras(place, 1);
        }
    }

    /** Returns the index of an event among the extra events; negative if it is not there. */
    private int placeOf(RunEvent event) {
        for (int i = 0; i < extras.size(); i++) {
            if (extras.get(i).event() == event) {
                return i;
            }
        }
        return -1;
    }

    /** Returns the number of extra events before a tick. */
    private int extrasBefore(long someTick) {
        int place = extras.size();
        while (place > 0 && extras.get(place - 1).event().tick() >= someTick) {
            place--;
        }
        return place;
    }

    private void insertExtras(int place, long next, List<? extends RunEvent> events) {
        extras.addAll(
                place, events.stream().map(event -> new Extra(next, event)).toList());
        fireTableRowsInserted(rowOf(place), rowOf(place) + events.size() - 1);
    }

    /** Removes extra events whose rows follow each other. */
    private void removeExtras(int place, int count) {
        int row = rowOf(place);
        extras.subList(place, place + count).clear();
        fireTableRowsDeleted(row, row + count - 1);
    }

    /** Returns the row of an extra event. */
    private int rowOf(int place) {
        return place + (int) (Math.max(firstEvent, extras.get(place).next()) - firstEvent);
    }

    /**
     * Adds lines that programs have printed, at the tick that is shown, of a time in seconds; the oldest lines are
     * dropped.
     */
    void addLines(List<String> lines, double time) {
        List<RunEvent.Printed> events = lines.stream()
                .skip(Math.max(0, lines.size() - MAX_LINES))
                .map(line -> new RunEvent.Printed(tick, time, line))
                .toList();
        if (!events.isEmpty()) {
            insertExtras(extrasBefore(tick + 1), log.endIndex(), events);
            dropOldestLines();
        }
    }

    private void dropOldestLines() {
        int surplus = (int) extras.stream().filter(Extra::isLine).count() - MAX_LINES;
        for (int place = 0; surplus > 0; ) {
            if (!extras.get(place).isLine()) {
                place++;
                continue;
            }
            int count = 1;
            while (count < surplus
                    && extras.get(place + count).isLine()
                    && rowOf(place + count) == rowOf(place) + count) {
                count++;
            }
            removeExtras(place, count);
            surplus -= count;
        }
    }

    /** Removes the events of the run and all lines. */
    void clear() {
        extras.removeIf(Extra::isLine);
        tick = 0;
        replaceLog(EventLog.EMPTY);
    }

    /** Shows a log at a tick, which is newer or of another run, and returns whether rows were added. */
    boolean update(EventLog newest, long newTick) {
        EventLog before = log;
        boolean continued = newTick >= tick && isContinuation(before, newest);
        tick = newTick;
        if (!continued) {
            replaceLog(newest);
            listGhostContact();
            return true;
        }
        RunEvent.Diverged marked = divergence;
        if (marked != null && insertsBeforeDivergence(marked, before, newest)) {
            setDivergence(null);
        }
        removeOldest(newest.firstIndex());
        appendEvents(newest);
        setDivergence(marked);
        listGhostContact();
        return newest.endIndex() > before.endIndex();
    }

    /** Shows the log of another run, or of the same one that was moved back, without what was added at later ticks. */
    private void replaceLog(EventLog newest) {
        log = newest;
        firstEvent = newest.firstIndex();
        extras.removeIf(extra -> extra.event() != divergence && extra.event().tick() > tick);
        extras.replaceAll(extra ->
                new Extra(newest.firstIndexSince(extra.event().tick() + (extra.isLine() ? 1 : 0)), extra.event()));
        fireTableDataChanged();
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
     * Removes the rows of dropped events; the other events keep theirs. With each notification, the table has exactly
     * the rows that are left, on which a sorter relies.
     */
    private void removeOldest(long newFirst) {
        for (int place = 0; place < extras.size() && firstEvent < newFirst; place++) {
            removeUntil(Math.min(newFirst, extras.get(place).next()), place);
        }
        removeUntil(newFirst, extras.size());
    }

    /** Removes events before a new first one, given the row of the old one. */
    private void removeUntil(long newFirst, int row) {
        int removed = (int) (newFirst - firstEvent);
        if (removed > 0) {
            firstEvent = newFirst;
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
        int low = 0;
        int high = extras.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (rowOf(middle) < row) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low < extras.size() && rowOf(low) == row ? extras.get(low).event() : log.get(firstEvent + row - low);
    }

    @Override
    public int getRowCount() {
        return (int) (log.endIndex() - firstEvent) + extras.size();
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
