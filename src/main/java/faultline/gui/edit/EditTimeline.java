package faultline.gui.edit;

import java.util.ArrayList;
import java.util.List;

/**
 * The ticks at which edits were done, undone and redone, so that what can be undone and redone follows the run when it
 * is moved to another tick.
 */
final class EditTimeline {

    private final EditHistory history;
    private final List<Entry> entries = new ArrayList<>();
    /** The number of entries that the run has passed. */
    private int position;

    /** An edit that was done or undone at the start of a tick. */
    private record Entry(long tick, CommandEdit edit, boolean done) {}

    EditTimeline(EditHistory history) {
        this.history = history;
    }

    /** Adds an edit that is done or undone now, as the last entry. */
    void add(long tick, CommandEdit edit, boolean done) {
        entries.add(new Entry(tick, edit, done));
        position = entries.size();
    }

    /** Returns the tick at which an edit was first done, 0 if it was done before the run started. */
    long firstTick(CommandEdit edit) {
        return entries.stream()
                .filter(entry -> entry.edit() == edit)
                .mapToLong(Entry::tick)
                .findFirst()
                .orElse(0);
    }

    /** Drops the entries that the run had not passed when a command was executed; returns whether there were any. */
    boolean fork(long tick) {
        advanceTo(tick - 1);
        boolean ahead = position < entries.size();
        entries.subList(position, entries.size()).clear();
        return ahead;
    }

    /** Follows the run to another tick; returns whether that undoes or redoes an edit. */
    boolean moveTo(long tick) {
        int before = position;
        while (position > 0 && entries.get(position - 1).tick() > tick) {
            position--;
            revert(entries.get(position));
        }
        return advanceTo(tick) || position != before;
    }

    /** Follows the run to a later tick; returns whether that undoes or redoes an edit. */
    boolean advanceTo(long tick) {
        int before = position;
        while (position < entries.size() && entries.get(position).tick() <= tick) {
            apply(entries.get(position));
            position++;
        }
        return position != before;
    }

    private void revert(Entry entry) {
        if (entry.done()) {
            history.markUndone(entry.edit(), true);
        } else {
            history.markDone(entry.edit());
        }
    }

    private void apply(Entry entry) {
        if (entry.done()) {
            history.markDone(entry.edit());
        } else {
            history.markUndone(entry.edit(), false);
        }
    }

    /** Restarts the run with all edits, including those that were ahead; none of them has a tick any more. */
    void restart() {
        advanceTo(Long.MAX_VALUE);
        clear();
    }

    void clear() {
        entries.clear();
        position = 0;
    }
}
