package faultline.gui.edit;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.document.RunController;
import faultline.gui.document.SensorRename;
import faultline.gui.text.Messages;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.awt.EventQueue;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.LongConsumer;
import java.util.function.LongFunction;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Sends the user's commands to the run and records the results as edits that can be undone and redone. Undo and redo
 * are themselves commands, so a journal replays them too. A refused command is not an edit. Event dispatch thread only.
 */
public final class UndoController {

    /** The longest pause between repeated commands about the same target that form one edit, milliseconds. */
    private static final long REPEAT_MILLIS = 1000;

    /** The kind of the targets of setup edits. */
    private static final String SETUP = "setup";

    private static final Set<Refusal.Reason> MISSING = EnumSet.of(
            Refusal.Reason.UNKNOWN_OBSTACLE,
            Refusal.Reason.UNKNOWN_SENSOR,
            Refusal.Reason.UNKNOWN_FAULT,
            Refusal.Reason.UNKNOWN_MOTOR_FAULT);

    private final BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel;
    private final Runnable onStateChange;
    private final LongSupplier clock;
    private final PendingEdits pendingEdits = new PendingEdits();
    private final EditHistory history = new EditHistory();
    private final UndoRequests requests = new UndoRequests(history, this::apply);
    private IntConsumer forkListener = laterEdits -> {};
    private LongConsumer undoListener = tick -> {};
    private LongFunction<List<Command>> plannedSince = tick -> List.of();
    private long advancedTo;
    private int gestureId;
    private boolean gestureActive;
    private int generation;
    private List<EditTarget> lastTargets = List.of();
    private long lastMillis;

    /**
     * Creates a controller without edits. The channel sends commands to the run, to be executed together, and passes
     * their results to a callback on the event dispatch thread.
     */
    public UndoController(BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel, Runnable onStateChange) {
        this(channel, onStateChange, () -> System.nanoTime() / 1_000_000);
    }

    UndoController(
            BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel,
            Runnable onStateChange,
            LongSupplier clock) {
        this.channel = channel;
        this.onStateChange = onStateChange;
        this.clock = clock;
    }

    /** Returns the commands that have no effect in a frame yet. */
    public PendingEdits pendingEdits() {
        return pendingEdits;
    }

    /** Sets the listener that is called with the number of edits that must be redone manually after an earlier edit. */
    public void setForkListener(IntConsumer listener) {
        forkListener = listener;
    }

    /** Sets the listener that is called when an edit is undone, with the tick at which it was first done. */
    public void setUndoListener(LongConsumer listener) {
        undoListener = listener;
    }

    /** Sets what returns the commands of the timeline that were executed after a tick. */
    public void setPlan(LongFunction<List<Command>> newPlannedSince) {
        plannedSince = newPlannedSince;
        history.setPlan(newPlannedSince);
    }

    /** Sets what returns whether the run is being restarted or moved to another tick. */
    public void setRepositioning(BooleanSupplier repositioning) {
        requests.setRepositioning(repositioning);
    }

    /** Sends one command. */
    public void send(Command command) {
        send(List.of(command));
    }

    /** Sends several commands, which form one edit. */
    public void send(List<Command> commands) {
        assert EventQueue.isDispatchThread();
        if (!commands.isEmpty()) {
            int id = gestureIdOf(commands.stream()
                    .map(command -> EditTarget.ofGesture(command, pendingEdits.controller()))
                    .toList());
            requests.editSent();
            onStateChange.run();
            submit(commands, results -> {
                recordEdit(id, results);
                requests.answered();
                onStateChange.run();
            });
        }
    }

    private void submit(List<Command> commands, Consumer<List<CommandResult>> onExecuted) {
        int sentIn = generation;
        Runnable onAnswered = pendingEdits.add(commands);
        channel.accept(commands, results -> {
            onAnswered.run();
            if (sentIn == generation) {
                onExecuted.accept(results);
            }
        });
    }

    /** Returns the id of a new gesture, unless one is active or the targets repeat the last ones. */
    private int gestureIdOf(List<EditTarget> targets) {
        long now = clock.getAsLong();
        boolean repeated = targets.equals(lastTargets)
                && now - lastMillis <= REPEAT_MILLIS
                && targets.stream().allMatch(EditTarget::repeatable);
        if (!gestureActive && !repeated) {
            gestureId++;
        }
        lastTargets = targets;
        lastMillis = now;
        return gestureId;
    }

    private void recordEdit(int sentAs, List<CommandResult> results) {
        checkFork(results);
        List<CommandResult> effective = results.stream()
                .filter(result -> result.refusal().isEmpty() && !result.isNoOp())
                .toList();
        if (!effective.isEmpty()) {
            CommandEdit edit = new CommandEdit(sentAs, effective);
            if (history.add(edit)) {
                history.addExecution(results.get(0).tick(), edit);
            }
        }
    }

    private void checkFork(List<CommandResult> results) {
        int later = isAnyExecuted(results) ? history.fork(results.get(0).tick()) : 0;
        if (later > 0) {
            forkListener.accept(later);
        }
    }

    private static boolean isAnyExecuted(List<CommandResult> results) {
        return results.stream().anyMatch(result -> result.refusal().isEmpty());
    }

    /**
     * Records a change of the setup that has been made. Changes with equal targets in quick succession form one edit.
     * The name is that in menus, in the current language.
     */
    public void addSetupEdit(Supplier<String> name, Object target, Runnable undoAction, Runnable redoAction) {
        assert EventQueue.isDispatchThread();
        int id = gestureIdOf(List.of(new EditTarget(SETUP, target, true)));
        addSetupEdit(new SetupEdit(name, id, undoAction, redoAction));
    }

    private void addSetupEdit(SetupEdit edit) {
        requests.editMade();
        history.add(edit);
        onStateChange.run();
    }

    /** Records that a sensor has got another id, given what changes ids. */
    void addRename(SensorRename rename, Consumer<SensorRename> action) {
        int id = gestureIdOf(List.of(new EditTarget(SETUP, rename, false)));
        addSetupEdit(new SetupEdit(
                () -> Messages.get("edit.renameSensor", rename.before(), rename.after()),
                id,
                () -> action.accept(rename.inverse()),
                () -> action.accept(rename),
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
        history.mark(edit, done);
        edit.apply(this, done);
        onStateChange.run();
    }

    /** Sends the commands that redo or undo an edit. */
    void submit(CommandEdit edit, boolean done) {
        List<Command> commands = done ? edit.redoCommands() : history.undoCommands(edit);
        if (!commands.isEmpty()) {
            submit(commands, results -> commandsExecuted(edit, done, results));
        }
    }

    private void commandsExecuted(CommandEdit edit, boolean done, List<CommandResult> results) {
        if (isAnyExecuted(results)) {
            checkFork(results);
            if (!done) {
                undoListener.accept(history.firstTick(edit));
            }
            history.addChange(results.get(0).tick(), edit, done, results);
        } else if (results.isEmpty() || !results.stream().allMatch(UndoController::isAboutNothing)) {
            // The world refused the command, or the run has died, so the edit does not change.
            history.mark(edit, !done);
            onStateChange.run();
        }
    }

    /**
     * Returns whether a command was refused because what it is about does not exist, so that there is nothing to do.
     */
    private static boolean isAboutNothing(CommandResult result) {
        return result.refusal().map(Refusal::reason).filter(MISSING::contains).isPresent();
    }

    /**
     * Follows the run to another tick, where the commands for the next one have been executed; later edits can be
     * redone, and are redone automatically when the run reaches them.
     *
     * @param tick the tick
     * @param setup the setup of the run
     * @param eventsOnTimeline whether all events of the run, such as faults, have become commands of the timeline,
     *     where they are undone
     * @param run changes the scenario
     */
    public void runRepositioned(long tick, SimulationSetup setup, boolean eventsOnTimeline, RunController run) {
        // A change of the setup repositions the run itself, and the next one may continue it.
        if (!lastTargets.stream().allMatch(target -> target.kind().equals(SETUP))) {
            endEdit();
        }
        boolean changed = history.moveTo(
                tick + 1, eventsOnTimeline, (edit, executed) -> timelineEdit(edit, executed, setup, run));
        if (changed || eventsOnTimeline) {
            onStateChange.run();
        }
    }

    /**
     * Follows the run as it advances, possibly past edits that were made before it was moved back, and past commands of
     * the timeline, which may end what an edit did.
     */
    public void runAdvanced(long tick) {
        boolean planned = tick != advancedTo && !plannedSince.apply(advancedTo).isEmpty();
        advancedTo = tick;
        if (history.advanceTo(tick) || planned) {
            onStateChange.run();
        }
    }

    /**
     * Follows a restart: all edits are part of the run from its start. Events, such as faults, are on the timeline of
     * the scenario now, where they are undone.
     *
     * @param before the setup of the run before
     * @param run changes the scenario
     */
    public void runRestarted(SimulationSetup before, RunController run) {
        endEdit();
        history.restart((edit, executed) -> timelineEdit(edit, executed, before, run));
        onStateChange.run();
    }

    /** Returns an edit of events as one whose executed commands are on the timeline of a setup. */
    private static EventEdit timelineEdit(
            Edit edit, List<CommandResult> executed, SimulationSetup setup, RunController run) {
        List<TimedCommand> events = executed.stream()
                .map(result -> new TimedCommand(setup.timeOf(result.tick()), result.command()))
                .toList();
        return edit instanceof EventEdit earlier
                ? earlier.with(events)
                : new EventEdit((CommandEdit) edit, events, run);
    }

    /** Follows the end of the work on the run: what has been undone or redone in the meantime takes effect. */
    public void taskFinished() {
        requests.process();
    }

    /** Starts a gesture: all commands until it ends form one edit. */
    public void beginGesture() {
        endEdit();
        gestureActive = true;
    }

    public void endGesture() {
        endEdit();
        gestureActive = false;
    }

    /** Ends the last edit: later commands form another one. Must be called when the scenario has been saved. */
    public void endEdit() {
        assert EventQueue.isDispatchThread();
        gestureId++;
        lastTargets = List.of();
    }

    /** Forgets all edits, because another scenario has been opened. */
    public void clear() {
        generation++;
        endEdit();
        pendingEdits.clear();
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
        return history.nextRedo().isPresent() || requests.isWaiting();
    }

    /** Returns the name of the edit that {@link #undo} would undo. */
    public Optional<String> undoName() {
        return history.nextUndo().map(Edit::name);
    }

    /** Returns the name of the edit that {@link #redo} would redo. */
    public Optional<String> redoName() {
        return history.nextRedo().map(Edit::name);
    }
}
