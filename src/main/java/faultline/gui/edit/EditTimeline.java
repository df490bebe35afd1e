package faultline.gui.edit;

import java.util.ArrayList;
import java.util.List;

/**
 * When edits were done, undone and redone, so that what can be undone and redone follows the run to other moments of
 * its time.
 */
final class EditTimeline {

    private final EditHistory history;
    private final List<TimelineEntry> entries = new ArrayList<>();
    /** How many of the moments the run has behind it. */
    private int position;

    /** An edit was done, or undone, at the start of a tick. */
    private record TimelineEntry(long tick, CommandEdit edit, boolean done) {}

    EditTimeline(EditHistory history) {
        this.history = history;
    }

    /** An edit is done or undone now; nothing is ahead any more. */
    void add(long tick, CommandEdit edit, boolean done) {
        entries.add(new TimelineEntry(tick, edit, done));
        position = entries.size();
    }

    /** The tick in which an edit was first done; 0 where it was there before the run began. */
    long firstTick(CommandEdit edit) {
        return entries.stream()
                .filter(moment -> moment.edit() == edit)
                .mapToLong(TimelineEntry::tick)
                .findFirst()
                .orElse(0);
    }

    /** Something is done now: what was ahead will not happen. Says whether anything was. */
    boolean discardAhead() {
        boolean ahead = position < entries.size();
        entries.subList(position, entries.size()).clear();
        return ahead;
    }

    /** The run stands after a tick, and what was done later is ahead. Says whether that changes anything. */
    boolean moveTo(long tick) {
        int before = position;
        while (position > 0 && entries.get(position - 1).tick() > tick) {
            position--;
            revert(entries.get(position));
        }
        return advanceTo(tick) || position != before;
    }

    /** The run has come past a tick. Says whether that changes anything. */
    boolean advanceTo(long tick) {
        int before = position;
        while (position < entries.size() && entries.get(position).tick() <= tick) {
            apply(entries.get(position));
            position++;
        }
        return position != before;
    }

    private void revert(TimelineEntry moment) {
        if (moment.done()) {
            history.undoQuietly(moment.edit(), true);
        } else {
            history.redoQuietly(moment.edit());
        }
    }

    private void apply(TimelineEntry moment) {
        if (moment.done()) {
            history.redoQuietly(moment.edit());
        } else {
            history.undoQuietly(moment.edit(), false);
        }
    }

    /** The run begins anew with all that was done, also what is ahead; from now on that has always been so. */
    void restart() {
        advanceTo(Long.MAX_VALUE);
        clear();
    }

    void clear() {
        entries.clear();
        position = 0;
    }
}
