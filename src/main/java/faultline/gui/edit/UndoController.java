package faultline.gui.edit;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.change.LaterChange;
import faultline.gui.change.Rename;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.text.Messages;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Records the results of the commands that a {@link CommandSender} sends as edits that can be undone and redone. Undo
 * and redo are themselves commands, so a journal replays them too. A refused command is not an edit. Event dispatch
 * thread only.
 */
public final class UndoController {

    private static final Set<Refusal.Reason> MISSING = EnumSet.of(
            Refusal.Reason.UNKNOWN_OBSTACLE,
            Refusal.Reason.UNKNOWN_SENSOR,
            Refusal.Reason.UNKNOWN_FAULT,
            Refusal.Reason.UNKNOWN_MOTOR_FAULT);

    private final CommandSender sender;
    private final Runnable onStateChange;
    private final Gestures gestures;
    private final EditHistory history = new EditHistory();
    private final UndoRequests requests = new UndoRequests(history, this::apply);
    private Consumer<ForkedEdits> forkListener = laterEdits -> {};
    private LongConsumer undoListener = tick -> {};
    private Consumer<List<CommandResult>> editListener = results -> {};
    private BiConsumer<String, Boolean> scenarioListener = (name, redone) -> {};
    private BiConsumer<List<LaterChange>, Consumer<List<CommandResult>>> laterChanges = (changes, onExecuted) -> {};
    private BiConsumer<List<CommandResult>, List<CommandResult>> undoNotes = (undone, results) -> {};
    private LongConsumer redoDrop = tick -> {};
    private StartChange startChange = (changes, redone, onChanged) -> {};
    private long advancedTo;

    /** Redoes or undoes changes of an earlier run at the start of the present one. */
    @FunctionalInterface
    private interface StartChange {
        void make(List<CommandResult> changes, boolean redone, Runnable onChanged);
    }

    /** Creates a controller without edits, which records the results of what a sender sends. */
    public UndoController(CommandSender sender, Runnable onStateChange) {
        this.sender = sender;
        this.onStateChange = onStateChange;
        this.gestures = sender.gestures();
        sender.setEditListener(this::editSent);
    }

    /** Sets the listener that is called with what must be redone and undone manually after an earlier edit. */
    public void setForkListener(Consumer<ForkedEdits> listener) {
        forkListener = listener;
    }

    /** Sets the listener that is called when an edit is undone, with the tick at which it was first done. */
    public void setUndoListener(LongConsumer listener) {
        undoListener = listener;
    }

    /** Sets the listener that receives the results of each edit, but not those of undo and redo. */
    public void setEditListener(Consumer<List<CommandResult>> listener) {
        editListener = listener;
    }

    /**
     * Sets the listener that is called when an edit is undone or redone in the scenario only, because its timeline has
     * changed the same thing in this run since, with the name of the edit and whether it is redone.
     */
    public void setScenarioListener(BiConsumer<String, Boolean> listener) {
        scenarioListener = listener;
    }

    /** Follows the run of a workspace, however it is moved and restarted. */
    public void follow(Workspace workspace, RunController run) {
        history.setPlan(run::plannedSince, run::presentResult);
        laterChanges = run::changeLater;
        startChange = run::changeStart;
        undoNotes = run::noteUndo;
        redoDrop = run::dropEventsWithoutEffectAfter;
        requests.setRun(run);
        workspace.addListener(new RunFollower(run));
    }

    /** Records that the commands of an edit are being sent; the returned callback receives their results. */
    private Consumer<List<CommandResult>> editSent(int gestureId) {
        requests.editSent();
        onStateChange.run();
        return results -> {
            recordEdit(gestureId, results);
            editListener.accept(results);
            requests.answered();
            onStateChange.run();
        };
    }

    private void recordEdit(int gestureId, List<CommandResult> results) {
        checkFork(results);
        List<CommandResult> effective = results.stream()
                .filter(result -> result.refusal().isEmpty() && !result.isNoOp())
                .toList();
        if (!effective.isEmpty()) {
            CommandEdit edit = new CommandEdit(gestureId, effective);
            long tick = results.get(0).tick();
            if (history.add(edit)) {
                history.addExecution(tick, edit);
            }
            redoDrop.accept(tick);
        }
    }

    private void checkFork(List<CommandResult> results) {
        if (isAnyExecuted(results)) {
            reportFork(history.fork(results.get(0).tick()));
        }
    }

    private void reportFork(ForkedEdits forked) {
        if (!forked.isEmpty()) {
            forkListener.accept(forked);
        }
    }

    private void startChanged() {
        reportFork(history.startChanged());
        onStateChange.run();
    }

    private static boolean isAnyExecuted(List<CommandResult> results) {
        return results.stream().anyMatch(result -> result.refusal().isEmpty());
    }

    /**
     * Records a change of the setup that has been made. Changes with equal targets in quick succession form one edit.
     * The name is that in menus, in the current language.
     */
    public void addSetupEdit(Supplier<String> name, Object target, SetupChange change) {
        assert EventQueue.isDispatchThread();
        int id = gestures.idOf(List.of(new EditTarget(EditTarget.SETUP, target, true)));
        addSetupEdit(new SetupEdit(name, id, change));
    }

    private void addSetupEdit(SetupEdit edit) {
        requests.editMade();
        history.add(edit);
        onStateChange.run();
    }

    /**
     * Makes an edit of what an edit that is being undone or redone may change, as soon as the run has answered that.
     */
    void editWhenAnswered(Runnable edit) {
        requests.editWhenAnswered(edit);
        onStateChange.run();
    }

    /** Records that a sensor or an obstacle has got another id, given what changes ids. */
    void addRename(Rename rename, Consumer<Rename> action) {
        int id = gestures.idOf(List.of(new EditTarget(EditTarget.SETUP, rename, false)));
        addSetupEdit(new SetupEdit(
                () -> Messages.get("edit.rename", rename.before(), rename.after()),
                id,
                SetupChange.of(() -> action.accept(rename.inverse()), () -> action.accept(rename)),
                List.of(rename)));
    }

    /**
     * Undoes the last edit, if there is one. Waits until the run has answered all commands before, and until it has
     * been restarted or moved; a new edit cancels that.
     */
    public void undo() {
        endEdit();
        requests.undo();
        onStateChange.run();
    }

    /** Redoes the edit that was undone last, if there is one; waits as {@link #undo} does. */
    public void redo() {
        requests.redo();
    }

    private void apply(Edit edit, boolean done) {
        Edit applied = edit instanceof EventEdit events && !done ? history.withUndoneEdits(events) : edit;
        history.mark(applied, done);
        applied.apply(this, done);
        onStateChange.run();
    }

    /** Sends the commands that redo or undo an edit, or changes the start of the run if the edit acts from there. */
    void submit(CommandEdit edit, boolean done) {
        if (edit.actsFromStart()) {
            startChange.make(edit.startChanges(done), done, this::startChanged);
            return;
        }
        List<LaterChange> changes = done ? history.redoChanges(edit) : history.undoChanges(edit);
        if (changes.isEmpty()) {
            return;
        }
        List<Command> commands = changes.stream()
                .flatMap(change -> Stream.ofNullable(change.inRun()))
                .toList();
        requests.requestSent();
        Consumer<List<CommandResult>> onExecuted = results -> {
            try {
                commandsExecuted(edit, done, changes, results);
            } finally {
                requests.requestAnswered();
            }
        };
        if (changes.stream().allMatch(change -> change.inScenario() == null)) {
            sender.submit(commands, onExecuted);
        } else {
            sender.submit(commands, received -> laterChanges.accept(changes, received), onExecuted);
        }
    }

    private void commandsExecuted(
            CommandEdit edit, boolean done, List<LaterChange> changes, List<CommandResult> results) {
        if (isAnyExecuted(results)) {
            checkFork(IntStream.range(0, results.size())
                    .filter(i -> changes.get(i).inRun() != null)
                    .mapToObj(results::get)
                    .toList());
            if (changes.stream().allMatch(change -> change.inRun() == null)) {
                scenarioListener.accept(edit.name(), done);
            } else if (!done) {
                undoListener.accept(history.firstTick(edit));
            }
        } else if (results.isEmpty() || !results.stream().allMatch(UndoController::isAboutNothing)) {
            // The world refused the command, or the run has died, so the edit does not change.
            if (done || results.isEmpty()) {
                history.mark(edit, !done);
            } else {
                history.undoRefused(edit);
            }
            onStateChange.run();
            return;
        }
        List<CommandResult> inScenario = IntStream.range(0, results.size())
                .mapToObj(i -> changes.get(i).resultInScenario(results.get(i)))
                .toList();
        if (!done) {
            undoNotes.accept(history.lastResults(edit), inScenario);
        }
        history.addChange(results.get(0).tick(), edit, done, inScenario);
    }

    /**
     * Returns whether a command was refused because what it is about does not exist, so that there is nothing to do.
     */
    private static boolean isAboutNothing(CommandResult result) {
        return result.refusal().map(Refusal::reason).filter(MISSING::contains).isPresent();
    }

    /**
     * Follows the run as it advances, possibly past edits that were made before it was moved back, and past commands of
     * the timeline, which may end what an edit did.
     */
    public void runAdvanced(long tick) {
        boolean planned = tick != advancedTo && history.mayHaveEnded(advancedTo);
        advancedTo = tick;
        if (history.advanceTo(tick) || planned) {
            onStateChange.run();
        }
    }

    /** Ends the last edit: later commands form another one. */
    public void endEdit() {
        assert EventQueue.isDispatchThread();
        gestures.interrupt();
    }

    /** Forgets all edits, because another scenario has been opened. */
    void clear() {
        sender.clear();
        requests.clear();
        history.clear();
        onStateChange.run();
    }

    /** Returns whether there is an edit that {@link #undo} undoes, now or when the run has answered. */
    public boolean canUndo() {
        return history.nextUndo().isPresent() || requests.awaitsEdit();
    }

    /** Returns whether there is an edit that {@link #redo} redoes, now or when the run has answered. */
    public boolean canRedo() {
        // An edit that is not answered yet drops those that can be redone.
        return requests.isWaiting()
                || !requests.awaitsEdit() && history.nextRedo().isPresent();
    }

    /** Returns the name of the edit that {@link #undo} would undo; empty while the run has not answered an edit. */
    public Optional<String> undoName() {
        return requests.awaitsEdit() ? Optional.empty() : history.nextUndo().map(Edit::name);
    }

    /** Returns the name of the edit that {@link #redo} would redo; empty while the run has not answered an edit. */
    public Optional<String> redoName() {
        return requests.awaitsEdit() ? Optional.empty() : history.nextRedo().map(Edit::name);
    }

    /** Keeps the history in step with the run. */
    private final class RunFollower implements WorkspaceListener {

        private final RunController run;

        RunFollower(RunController run) {
            this.run = run;
        }

        @Override
        public void scenarioOpened() {
            clear();
        }

        @Override
        public void scenarioSaved(Path file) {
            endEdit();
        }

        @Override
        public void editsIncluded(SimulationSetup before) {
            includeEdits(before);
        }

        /** All edits are part of the run from its start. Events are on the timeline now, where they are undone. */
        @Override
        public void scenarioRestarted(SimulationSetup before) {
            includeEdits(before);
        }

        private void includeEdits(SimulationSetup before) {
            endEdit();
            history.restart((edit, executed) -> timelineEdit(edit, executed, before));
            onStateChange.run();
        }

        @Override
        public void eventsPutOnTimeline(SimulationSetup setup) {
            history.putEventsOnTimeline((edit, executed) -> timelineEdit(edit, executed, setup));
        }

        /** Later edits can be redone, and are redone automatically when the run reaches them. */
        @Override
        public void runRepositioned(long tick, SimulationSetup setup, boolean eventsOnTimeline) {
            // A change of the setup repositions the run itself, and the next one may continue it.
            if (!gestures.areLastOf(EditTarget.SETUP)) {
                endEdit();
            }
            // The commands for the next tick have been executed.
            boolean changed =
                    history.moveTo(tick + 1, eventsOnTimeline, (edit, executed) -> timelineEdit(edit, executed, setup));
            if (changed || eventsOnTimeline) {
                onStateChange.run();
            }
        }

        /** Returns an edit of events as one whose executed commands are on the timeline of a setup. */
        private EventEdit timelineEdit(Edit edit, List<CommandResult> executed, SimulationSetup setup) {
            List<TimedCommand> events = executed.stream()
                    .map(result -> new TimedCommand(setup.timeOf(result.tick()), result.command()))
                    .toList();
            return edit instanceof EventEdit earlier
                    ? earlier.with(events)
                    : new EventEdit((CommandEdit) edit, events, run);
        }
    }
}
