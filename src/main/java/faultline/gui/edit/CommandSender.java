package faultline.gui.edit;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.awt.EventQueue;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.function.LongSupplier;
import java.util.function.UnaryOperator;

/**
 * Sends the user's commands to the run. Numbers the gestures that they belong to, keeps those that have no effect in a
 * frame yet, and passes the results to a listener, which {@link UndoController} sets to record them as edits. Event
 * dispatch thread only.
 */
public final class CommandSender {

    private final BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel;
    private final Gestures gestures;
    private final PendingEdits pendingEdits = new PendingEdits();
    private IntFunction<Consumer<List<CommandResult>>> editListener = gestureId -> results -> {};
    private UnaryOperator<Command> naming = UnaryOperator.identity();
    private int generation;

    /**
     * Creates a sender. The channel sends commands to the run, to be executed together, and passes their results to a
     * callback on the event dispatch thread.
     */
    public CommandSender(BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel) {
        this(channel, () -> System.nanoTime() / 1_000_000);
    }

    /** Creates a sender, given a clock that returns milliseconds. */
    CommandSender(BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel, LongSupplier clock) {
        this.channel = channel;
        this.gestures = new Gestures(clock);
    }

    /**
     * Sets the listener that is called with the id of the gesture before the commands of an edit are sent. It returns
     * what receives their results.
     */
    void setEditListener(IntFunction<Consumer<List<CommandResult>>> listener) {
        editListener = listener;
    }

    /** Sets what gives a command of the views the id that its obstacle has in the edited scenario. */
    public void setNaming(UnaryOperator<Command> newNaming) {
        naming = newNaming;
    }

    /** Returns the commands that have no effect in a frame yet. */
    public PendingEdits pendingEdits() {
        return pendingEdits;
    }

    /** Returns the gestures, which also number the edits that are made without commands. */
    Gestures gestures() {
        return gestures;
    }

    /** Sends one command. */
    public void send(Command command) {
        send(List.of(command));
    }

    /** Sends several commands, which form one edit. */
    public void send(List<Command> commands) {
        assert EventQueue.isDispatchThread();
        if (!commands.isEmpty()) {
            int gestureId = gestures.idOf(commands.stream()
                    .map(command -> EditTarget.ofGesture(command, pendingEdits.controller()))
                    .toList());
            List<Command> named = commands.stream().map(naming).toList();
            submit(commands, received -> channel.accept(named, received), editListener.apply(gestureId));
        }
    }

    /**
     * Sends commands that are not a new edit, such as those that undo one. The callback gets their results unless
     * another scenario has been opened by then.
     */
    void submit(List<Command> commands, Consumer<List<CommandResult>> onExecuted) {
        submit(commands, received -> channel.accept(commands, received), onExecuted);
    }

    /** Sends commands as {@link #submit(List, Consumer)} does, given what sends them and passes on their results. */
    void submit(
            List<Command> commands,
            Consumer<Consumer<List<CommandResult>>> action,
            Consumer<List<CommandResult>> onExecuted) {
        int sentIn = generation;
        Runnable onAnswered = pendingEdits.add(commands);
        action.accept(results -> {
            onAnswered.run();
            if (sentIn == generation) {
                onExecuted.accept(results);
            }
        });
    }

    /** Starts a gesture: all commands until it ends form one edit. */
    public void beginGesture() {
        gestures.begin();
    }

    public void endGesture() {
        gestures.end();
    }

    /** Forgets all commands that have been sent, because another scenario has been opened. */
    void clear() {
        assert EventQueue.isDispatchThread();
        generation++;
        gestures.interrupt();
        pendingEdits.clear();
    }
}
