package faultline.gui.edit;

import faultline.gui.change.LaterChange;
import faultline.gui.change.Rename;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The edits, and a cursor between those that are done and those that are undone. A new edit drops the undone ones, but
 * keeps those that are undone only because the run stands at an earlier tick: they can still be redone. The history
 * logs the ticks at which edits were done and undone, so that it follows the run when it is moved to another tick.
 * Commands have the ids that sensors had when they were executed, so those of an edit that changes its place among
 * edits that rename sensors are renamed, too.
 */
final class EditHistory {

    private static final int MAX_EDITS = 1000;
    private static final Predicate<EditChange> IS_EVENT =
            change -> change.edit().hasOnlyEvents();

    private final List<Edit> edits = new ArrayList<>();
    /** The number of edits that are done; they come first. */
    private int cursor;

    private final EditLog log = new EditLog();
    private final RefusedUndos refusedUndos = new RefusedUndos();
    private LongFunction<List<Command>> plannedSince = tick -> List.of();
    private UnaryOperator<CommandResult> presentResult = UnaryOperator.identity();

    /**
     * Sets what returns the commands of the timeline that were executed after a tick, and what gives the result of an
     * event what undoes it with the present timeline.
     */
    void setPlan(LongFunction<List<Command>> newPlannedSince, UnaryOperator<CommandResult> newPresentResult) {
        plannedSince = newPlannedSince;
        presentResult = newPresentResult;
    }

    /**
     * Adds an edit that is done. One of the same gesture as the last edit is merged into it; one without effect is
     * dropped. Returns whether the edit has become a separate entry.
     */
    boolean add(Edit edit) {
        refusedUndos.clear();
        List<CommandEdit> ahead = editsAhead();
        dropUndone();
        if (!isMerged(edit)) {
            edits.add(edit);
        } else if (last() instanceof SetupEdit last && last.change().isNoOp()) {
            edits.remove(last);
        } else if (last() instanceof CommandEdit last && last.isNoOp()) {
            dropCancelled(last);
        }
        edits.subList(0, Math.max(0, edits.size() - MAX_EDITS)).clear();
        cursor = edits.size();
        if (edit instanceof SetupEdit setup) {
            // The edits ahead are not in the list now.
            renameDropped(setup.renames());
        }
        edits.addAll(ahead);
        return edits.contains(edit);
    }

    /** Drops an edit that has been undone by its last commands, but not at the ticks before them. */
    private void dropCancelled(CommandEdit edit) {
        edits.remove(edit);
        long tick = edit.lastTick();
        edit.cutAfter(tick - 1);
        if (edit.results().isEmpty()) {
            log.removeIf(change -> change.edit() == edit);
        } else {
            log.add(new EditChange(tick, edit, false, List.of()));
        }
    }

    /** Drops the edits that are undone. Their commands get the ids that the sensors have now. */
    private void dropUndone() {
        List<Edit> undone = edits.subList(cursor, edits.size());
        for (Edit edit : undone) {
            if (edit instanceof CommandEdit command) {
                renamesToNow(command).forEach(rename -> rename(command, rename));
            }
        }
        undone.clear();
    }

    /** Returns the changes of ids that lead from those that an edit has to the present ones. */
    private List<Rename> renamesToNow(Edit edit) {
        int index = edits.indexOf(edit);
        if (index < 0) {
            return List.of();
        }
        return index < cursor
                ? renames(edits.subList(index, cursor))
                : Rename.inverse(renames(edits.subList(cursor, index)));
    }

    private static List<Rename> renames(List<Edit> some) {
        return some.stream()
                .flatMap(edit -> edit instanceof SetupEdit setup ? setup.renames().stream() : Stream.of())
                .toList();
    }

    /** Returns the result of a command of an edit with the id that its sensor has now. */
    private CommandResult named(Edit edit, CommandResult result) {
        CommandResult named = result;
        for (Rename rename : renamesToNow(edit)) {
            named = rename.rename(named);
        }
        return named;
    }

    /** Gives the commands of edits that have been dropped, but executed in this run, other ids. */
    private void renameDropped(List<Rename> renames) {
        log.edits()
                .filter(edit -> !edits.contains(edit))
                .toList()
                .forEach(edit -> renames.forEach(rename -> rename(edit, rename)));
    }

    private boolean isMerged(Edit edit) {
        if (last() instanceof SetupEdit last
                && edit instanceof SetupEdit newer
                && last.gestureId() == newer.gestureId()) {
            edits.set(edits.size() - 1, last.mergedWith(newer));
            return true;
        }
        return last() instanceof CommandEdit last
                && edit instanceof CommandEdit newer
                && last.merge(newer, plannedSince);
    }

    private Edit last() {
        return edits.isEmpty() ? null : edits.get(edits.size() - 1);
    }

    /** Returns the edits that can be redone only because the run stands at an earlier tick. */
    List<CommandEdit> editsAhead() {
        return edits.subList(cursor, edits.size()).stream()
                .filter(edit -> edit instanceof CommandEdit command && command.isAhead())
                .map(CommandEdit.class::cast)
                .toList();
    }

    /**
     * Returns the edit that is undone next: the last one of those that are done whose undo has an effect. One whose
     * undo was refused is passed over as long as an edit before it changes other things; then it is tried again.
     */
    Optional<Edit> nextUndo() {
        return refusedUndos.next(edits.subList(0, cursor), this::isEffective);
    }

    /** Records that the undo of an edit was refused, so that those before it can be undone; it stays where it was. */
    void undoRefused(CommandEdit edit) {
        refusedUndos.add(edit);
        mark(edit, true, false);
        int last = edits.indexOf(edit);
        edits.add(refusedUndos.placeOf(edit, last), edits.remove(last));
    }

    /** Returns whether the timeline may have ended what an edit did since a tick; fast if there is no such edit. */
    boolean mayHaveEnded(long tick) {
        return edits.subList(0, cursor).stream()
                        .anyMatch(edit -> edit instanceof CommandEdit command && command.hasOnlyEvents())
                && !plannedSince.apply(tick).isEmpty();
    }

    private boolean isEffective(Edit edit) {
        return edit instanceof CommandEdit command
                ? !command.hasOnlyEvents() || !undoChanges(command).isEmpty()
                : edit.isEffective();
    }

    /** Returns what undoes an edit as it was done last; nothing if the timeline has ended what it did. */
    List<LaterChange> undoChanges(CommandEdit edit) {
        List<CommandResult> present =
                lastResults(edit).stream().map(presentResult).toList();
        return edit.undoChanges(present, firstResults(edit), plannedSince);
    }

    /** Returns the results of an edit when it was done last. */
    List<CommandResult> lastResults(CommandEdit edit) {
        return log.passed(edit)
                .filter(EditChange::done)
                .reduce((earlier, later) -> later)
                .map(EditChange::executed)
                .orElseGet(edit::results);
    }

    /** Returns the results of an edit when it was first executed before the present tick; it may be redone earlier. */
    private List<CommandResult> firstResults(CommandEdit edit) {
        return log.passed(edit).findFirst().map(EditChange::executed).orElseGet(edit::results);
    }

    /** Returns what redoes an edit. */
    List<LaterChange> redoChanges(CommandEdit edit) {
        return edit.redoChanges(firstResults(edit), plannedSince);
    }

    /** Returns the edit that is redone next. */
    Optional<Edit> nextRedo() {
        return cursor < edits.size() ? Optional.of(edits.get(cursor)) : Optional.empty();
    }

    /** Makes an edit that is done the last such, or one that is undone the first such, if its state changes. */
    void mark(Edit edit, boolean done) {
        if (done) {
            refusedUndos.redone(edit);
        } else {
            refusedUndos.undone(edit, edits.indexOf(edit));
        }
        mark(edit, done, false);
    }

    private void mark(Edit edit, boolean done, boolean ahead) {
        int index = edits.indexOf(edit);
        if (index < 0 && done) {
            // A new edit has dropped it after it was undone, and the run has been moved to a tick before that.
            edits.add(cursor, edit);
            cursor++;
        } else if (index >= 0 && index < cursor != done) {
            edits.remove(index);
            cursor += done ? 0 : -1;
            edits.add(cursor, edit);
            cursor += done ? 1 : 0;
            if (edit instanceof CommandEdit command) {
                command.setAhead(ahead);
                rename(command, index);
            } else if (edit instanceof SetupEdit setup) {
                List<Rename> made = done ? setup.renames() : Rename.inverse(setup.renames());
                renamePassed(index, edits.indexOf(edit), made);
                renameDropped(made);
            }
        }
    }

    /** Gives the commands of an edit that is at the cursor the ids of its place, given the index that it had before. */
    private void rename(CommandEdit edit, int before) {
        int now = edits.indexOf(edit);
        List<Rename> passed = renames(List.copyOf(edits.subList(Math.min(now + 1, before), Math.max(now, before + 1))));
        (now < before ? Rename.inverse(passed) : passed).forEach(rename -> rename(edit, rename));
    }

    /** Gives the edits that changes of ids have passed in the list the ids of their places. */
    private void renamePassed(int before, int now, List<Rename> made) {
        for (int i = Math.min(before, now + 1); i < Math.max(before + 1, now); i++) {
            for (Rename rename : made) {
                if (edits.get(i) instanceof CommandEdit command) {
                    rename(command, rename);
                } else if (edits.get(i) instanceof EventEdit events) {
                    edits.set(i, events.renamed(rename));
                }
            }
        }
    }

    private void rename(CommandEdit edit, Rename rename) {
        edit.rename(rename);
        log.rename(edit, rename);
    }

    /** Records that a new edit was done at a tick, before those that are ahead. */
    void addExecution(long tick, CommandEdit edit) {
        addChange(new EditChange(tick, edit, true, List.of()));
    }

    /** Records that an edit was redone or undone at a tick, before those that are ahead, with the results. */
    void addChange(long tick, CommandEdit edit, boolean done, List<CommandResult> results) {
        addChange(new EditChange(tick, edit, done, results));
    }

    private void addChange(EditChange change) {
        advanceTo(change.tick() - 1);
        log.add(change);
    }

    /** Returns the tick at which an edit was first done, 0 if it was done before the run started. */
    long firstTick(CommandEdit edit) {
        return log.firstTick(edit);
    }

    /**
     * Drops what the run had not executed when a command was executed, also of a gesture that it had passed in part;
     * returns what is no longer redone and undone automatically.
     */
    ForkedEdits fork(long tick) {
        advanceTo(tick - 1);
        log.cutGestures();
        List<EditChange> dropped = log.ahead();
        log.removeAhead();
        advanceTo(tick);
        return forked(dropped);
    }

    /** Returns what changes that have been dropped would have redone and undone. */
    private ForkedEdits forked(List<EditChange> dropped) {
        if (dropped.isEmpty()) {
            return new ForkedEdits(0, 0);
        }
        Map<Edit, Boolean> last = new HashMap<>();
        dropped.forEach(change -> last.put(change.edit(), change.done()));
        long undos = edits.subList(0, cursor).stream()
                .filter(edit -> Boolean.FALSE.equals(last.get(edit)))
                .count();
        return new ForkedEdits(editsAhead().size(), (int) undos);
    }

    /**
     * Follows the run to another tick; returns whether that undoes or redoes an edit. If all events of the run have
     * become commands of the timeline, the edits of those that are done are replaced.
     */
    boolean moveTo(long tick, boolean eventsOnTimeline, BiFunction<Edit, List<CommandResult>, Edit> replacement) {
        refusedUndos.clear();
        if (eventsOnTimeline) {
            putEventsOnTimeline(replacement);
        }
        boolean reverted = log.retreatTo(tick, change -> mark(change.edit(), !change.done(), change.done()));
        return advanceTo(tick) || reverted;
    }

    /** Replaces the edits of events that are done: all events of the run have become commands of the timeline. */
    void putEventsOnTimeline(BiFunction<Edit, List<CommandResult>, Edit> replacement) {
        replaceEvents(replacement);
        log.removeIf(IS_EVENT);
    }

    /** Follows the run to a later tick; returns whether that undoes or redoes an edit. */
    boolean advanceTo(long tick) {
        return log.advanceTo(tick, change -> mark(change.edit(), change.done()));
    }

    /**
     * Includes all edits in the start of another run, also those that were ahead, without their ticks. Edits of events
     * that are done are replaced, as by {@link #moveTo}.
     */
    void restart(BiFunction<Edit, List<CommandResult>, Edit> replacement) {
        refusedUndos.clear();
        advanceTo(Long.MAX_VALUE);
        replaceEvents(replacement);
        for (Edit edit : edits) {
            if (edit instanceof CommandEdit command) {
                command.runStarted(firstResults(command));
            }
        }
        log.clear();
    }

    /**
     * Forgets when edits of this run were done and undone, except for events: the run is simulated without them.
     * Returns what is no longer redone and undone automatically.
     */
    ForkedEdits startChanged() {
        log.cutGestures();
        List<EditChange> dropped =
                log.ahead().stream().filter(IS_EVENT.negate()).toList();
        log.removeIf(IS_EVENT.negate());
        return forked(dropped);
    }

    /** Replaces the edits of events that are done, given what was executed for them in this run. */
    private void replaceEvents(BiFunction<Edit, List<CommandResult>, Edit> replacement) {
        List<Edit> done = edits.subList(0, cursor);
        ExecutedEvents executed = new ExecutedEvents(done, this::named);
        log.changes().stream().filter(IS_EVENT).forEach(change -> executed.add(change.edit(), change.executed()));
        // An edit that had no effect when it was redone has none on the timeline either.
        done.replaceAll(
                edit -> edit instanceof CommandEdit command && command.hasOnlyEvents() || executed.count(edit) > 0
                        ? replacement.apply(edit, executed.of(edit))
                        : edit);
    }

    /**
     * Lets an edit whose events are on the timeline also have what was executed in this run for later edits of the same
     * switches and faults that have been undone. Returns the edit that takes its place, or itself if there is nothing.
     */
    EventEdit withUndoneEdits(EventEdit edit) {
        // Later edits of the timeline have no effect, since this one is the next to be undone.
        int index = edits.indexOf(edit);
        List<Edit> owners = IntStream.range(0, cursor)
                .filter(i -> i <= index || edits.get(i) instanceof CommandEdit)
                .mapToObj(edits::get)
                .toList();
        ExecutedEvents executed = new ExecutedEvents(owners, this::named);
        List<EditChange> kept = new ArrayList<>();
        for (EditChange change : log.passed()) {
            List<CommandResult> all = IS_EVENT.test(change) ? change.executed() : List.of();
            List<CommandResult> others = all.stream()
                    .filter(result -> !executed.add(change.edit(), result, edit))
                    .toList();
            if (others.size() == all.size()) {
                kept.add(change);
            } else if (!others.isEmpty()) {
                kept.add(change.with(others));
            }
        }
        if (executed.count(edit) == 0) {
            return edit;
        }
        log.setPassed(kept);
        EventEdit replaced = edit.withExecuted(executed.of(edit));
        edits.set(edits.indexOf(edit), replaced);
        return replaced;
    }

    void clear() {
        refusedUndos.clear();
        log.clear();
        edits.clear();
        cursor = 0;
    }
}
