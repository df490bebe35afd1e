package faultline.gui.edit;

import faultline.gui.change.Rename;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * The log of a run: the ticks at which edits of commands were done and undone, in the order of the ticks, and a cursor
 * after the changes that the run has passed. The changes after it are those of ticks that a moved run has not reached.
 */
final class EditLog {
    private final List<EditChange> changes = new ArrayList<>();
    /** The number of changes that the run has passed. */
    private int passed;
    /** The tick whose commands the run has executed last. */
    private long tick;
    /** The last such tick before the run was moved back. */
    private long latest;

    /** Returns the edits that were done or undone in the run, each once. */
    Stream<CommandEdit> edits() {
        return changes.stream().map(EditChange::edit).distinct();
    }

    /** Returns all changes, also those that the run has not passed. */
    List<EditChange> changes() {
        return List.copyOf(changes);
    }

    /** Returns the changes that the run has passed. */
    List<EditChange> passed() {
        return List.copyOf(changes.subList(0, passed));
    }

    /** Returns the changes of an edit that the run has passed. */
    Stream<EditChange> passed(CommandEdit edit) {
        return changes.subList(0, passed).stream().filter(change -> change.edit() == edit);
    }

    /** Returns the tick at which an edit was first done, 0 if it was done before the run started. */
    long firstTick(CommandEdit edit) {
        return changes.stream()
                .filter(change -> change.edit() == edit)
                .mapToLong(EditChange::tick)
                .findFirst()
                .orElse(0);
    }

    /** Adds a change at the cursor and passes it. Later changes of the same edit are removed. */
    void add(EditChange change) {
        // The run has executed none of those that are ahead of one that it does not execute either.
        changes.subList(passed, changes.size()).removeIf(later -> later.edit() == change.edit());
        changes.add(passed, change);
        passed++;
    }

    /** Replaces the changes that the run has passed. */
    void setPassed(List<EditChange> newPassed) {
        changes.subList(0, passed).clear();
        changes.addAll(0, newPassed);
        passed = newPassed.size();
    }

    /** Gives the results of an edit's changes the new id of a sensor. */
    void rename(CommandEdit edit, Rename rename) {
        changes.replaceAll(change -> change.edit() == edit ? change.renamed(rename) : change);
    }

    /** Removes the changes that meet a condition, also those that the run has not passed. */
    void removeIf(Predicate<EditChange> condition) {
        passed -= (int) changes.subList(0, passed).stream().filter(condition).count();
        changes.removeIf(condition);
    }

    /** Returns the changes that the run has not passed. */
    List<EditChange> ahead() {
        return List.copyOf(changes.subList(passed, changes.size()));
    }

    /** Removes the changes that the run has not passed. */
    void removeAhead() {
        changes.subList(passed, changes.size()).clear();
    }

    /** Drops the commands that the run has not executed of gestures that it has passed in part. */
    void cutGestures() {
        if (tick < latest) {
            passed().stream().filter(EditChange::isFirst).forEach(change -> change.edit()
                    .cutAfter(tick));
            latest = tick;
        }
    }

    /** Moves the cursor back before the changes after a tick, from the last one; returns whether there were any. */
    boolean retreatTo(long newTick, Consumer<EditChange> revert) {
        int before = passed;
        tick = Math.min(tick, newTick);
        while (passed > 0 && changes.get(passed - 1).tick() > newTick) {
            passed--;
            revert.accept(changes.get(passed));
        }
        return passed != before;
    }

    /** Moves the cursor forward over the changes up to a tick; returns whether there were any. */
    boolean advanceTo(long newTick, Consumer<EditChange> repeat) {
        int before = passed;
        tick = Math.max(tick, newTick);
        latest = Math.max(latest, tick);
        while (passed < changes.size() && changes.get(passed).tick() <= newTick) {
            repeat.accept(changes.get(passed));
            passed++;
        }
        return passed != before;
    }

    void clear() {
        changes.clear();
        passed = 0;
        tick = 0;
        latest = 0;
    }
}
