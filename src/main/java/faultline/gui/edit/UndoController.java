package faultline.gui.edit;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javax.swing.undo.UndoableEdit;

/**
 * Passes what a user does on to the run, and remembers what the run made of it, so that it can be undone and redone by
 * name. Undoing is itself a command to the run, so a journal replays it like all else. A command that is refused is no
 * edit.
 */
public final class UndoController implements CommandSink {

    /** Repeated commands about one thing that are no farther apart than this are one edit, milliseconds. */
    private static final long REPEAT_MILLIS = 1000;

    private final CommandChannel channel;
    private final Runnable onStateChange;
    private final LongSupplier millis;
    private final EditHistory history = new EditHistory();
    private final EditTimeline timeline = new EditTimeline(history);
    private Optional<EditListener> listener = Optional.empty();
    private int gestureId;
    private boolean gestureActive;
    private int generation;
    private List<EditTarget> lastTargets = List.of();
    private long lastMillis;

    /** The way to the run. */
    @FunctionalInterface
    public interface CommandChannel {

        /**
         * Gives commands that are carried out together.
         *
         * @param commands what is to be done, in order
         * @param told gets what became of each, on the event dispatch thread, soon
         */
        void send(List<Command> commands, Consumer<List<CommandResult>> told);
    }

    /**
     * A desk without edits.
     *
     * @param channel the way to the run
     * @param changed told whenever what can be undone or redone is another
     */
    public UndoController(CommandChannel channel, Runnable changed) {
        this(channel, changed, () -> System.nanoTime() / 1_000_000);
    }

    UndoController(CommandChannel channel, Runnable changed, LongSupplier millis) {
        this.channel = channel;
        this.onStateChange = changed;
        this.millis = millis;
    }

    @Override
    public void send(Command command) {
        send(List.of(command));
    }

    @Override
    public void send(List<Command> commands) {
        assert EventQueue.isDispatchThread();
        if (commands.isEmpty()) {
            return;
        }
        int now = gestureIdOf(commands);
        int sentIn = generation;
        channel.send(commands, outcomes -> {
            if (sentIn == generation) {
                recordEdit(now, outcomes);
            }
        });
    }

    /** A new gesture, unless a hand holds on or the commands repeat the last ones. */
    private int gestureIdOf(List<Command> commands) {
        List<EditTarget> about = commands.stream().map(EditTarget::of).toList();
        long now = millis.getAsLong();
        boolean repeated = about.equals(lastTargets)
                && now - lastMillis <= REPEAT_MILLIS
                && about.stream().allMatch(EditTarget::repeatable);
        if (!gestureActive && !repeated) {
            gestureId++;
        }
        lastTargets = about;
        lastMillis = now;
        return gestureId;
    }

    private void recordEdit(int sentAs, List<CommandResult> outcomes) {
        List<ReversibleCommand> steps = outcomes.stream()
                .filter(outcome -> outcome.refusal().isEmpty())
                .map(outcome -> new ReversibleCommand(outcome.command(), outcome.inverse()))
                .filter(step -> !step.isNoOp())
                .toList();
        checkFork(outcomes);
        if (!steps.isEmpty()) {
            CommandEdit edit = new CommandEdit(sentAs, steps, this::sendUndoOrRedo);
            history.addEdit(edit);
            if (history.contains(edit)) {
                timeline.add(outcomes.get(0).tick(), edit, true);
            }
            onStateChange.run();
        }
    }

    private void sendUndoOrRedo(CommandEdit edit, boolean done, List<Command> commands) {
        if (!history.isQuiet()) {
            int sentIn = generation;
            channel.send(commands, outcomes -> {
                if (sentIn == generation) {
                    undoOrRedoExecuted(edit, done, outcomes);
                }
            });
        }
    }

    private void undoOrRedoExecuted(CommandEdit edit, boolean done, List<CommandResult> outcomes) {
        if (outcomes.stream().anyMatch(outcome -> outcome.refusal().isEmpty())) {
            checkFork(outcomes);
            if (!done) {
                listener.ifPresent(told -> told.editUndone(timeline.firstTick(edit)));
            }
            timeline.add(outcomes.get(0).tick(), edit, done);
        } else {
            history.revert(edit, done);
            onStateChange.run();
        }
    }

    private void checkFork(List<CommandResult> outcomes) {
        if (outcomes.stream().anyMatch(outcome -> outcome.refusal().isEmpty()) && timeline.discardAhead()) {
            listener.ifPresent(told -> told.timelineForked(history.editsAhead().size()));
        }
    }

    /**
     * Sets who is told what becomes of edits.
     *
     * @param told on the event dispatch thread
     */
    public void setListener(EditListener told) {
        listener = Optional.of(told);
    }

    /**
     * The run was taken to another moment: edits after it can be redone, and come by themselves when the run comes to
     * them.
     *
     * @param tick after which the run stands
     */
    public void runRepositioned(long tick) {
        assert EventQueue.isDispatchThread();
        endEdit();
        if (timeline.moveTo(tick)) {
            onStateChange.run();
        }
    }

    /**
     * The run goes on, maybe past edits that were made before it was taken back.
     *
     * @param tick it has come to
     */
    public void runAdvanced(long tick) {
        if (timeline.advanceTo(tick)) {
            onStateChange.run();
        }
    }

    /** The run begins anew, with all edits as if they had always been there. */
    public void runRestarted() {
        assert EventQueue.isDispatchThread();
        endEdit();
        timeline.restart();
        onStateChange.run();
    }

    /**
     * Remembers an edit that has been made by beginning anew.
     *
     * @param edit can be undone
     */
    public void addEdit(UndoableEdit edit) {
        runRestarted();
        history.addEdit(edit);
        onStateChange.run();
    }

    @Override
    public void beginGesture() {
        endEdit();
        gestureActive = true;
    }

    @Override
    public void endGesture() {
        endEdit();
        gestureActive = false;
    }

    /**
     * Keeps what was done from growing further: what comes is another edit. To be called when the scenario has been
     * saved.
     */
    public void endEdit() {
        assert EventQueue.isDispatchThread();
        gestureId++;
        lastTargets = List.of();
    }

    /** Forgets all edits, because they were another scenario's. */
    public void clear() {
        assert EventQueue.isDispatchThread();
        generation++;
        endEdit();
        timeline.clear();
        history.discardAllEdits();
        onStateChange.run();
    }

    /** Takes the last edit back, if there is one. */
    public void undo() {
        perform(history.canUndo(), history::undo);
    }

    /** Does the edit again that was taken back last, if there is one. */
    public void redo() {
        perform(history.canRedo(), history::redo);
    }

    private void perform(boolean possible, Runnable way) {
        assert EventQueue.isDispatchThread();
        endEdit();
        if (possible) {
            way.run();
            onStateChange.run();
        }
    }

    /**
     * What {@link #undo} would take back.
     *
     * @return the name of an edit, empty where there is none
     */
    public Optional<String> undoName() {
        return history.canUndo() ? Optional.of(history.undoName()) : Optional.empty();
    }

    /**
     * What {@link #redo} would do again.
     *
     * @return the name of an edit, empty where there is none
     */
    public Optional<String> redoName() {
        return history.canRedo() ? Optional.of(history.redoName()) : Optional.empty();
    }
}
