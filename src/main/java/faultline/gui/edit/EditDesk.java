package faultline.gui.edit;

import faultline.engine.Session.Outcome;
import faultline.world.Command;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javax.swing.undo.UndoableEdit;

/**
 * Passes what a user does on to the run, and remembers what the run made of it, so that it can be undone and redone by name. Undoing is
 * itself a command to the run, so a journal replays it like all else. A command that is refused is no edit.
 */
public final class EditDesk implements Editor {

    /** Repeated commands about one thing that are no farther apart than this are one edit, milliseconds. */
    private static final long REPEAT_MILLIS = 1000;

    private final Channel channel;
    private final Runnable changed;
    private final LongSupplier millis;
    private final EditHistory history = new EditHistory();
    private final Chronicle chronicle = new Chronicle(history);
    private Optional<EditNews> news = Optional.empty();
    private int gesture;
    private boolean held;
    private int era;
    private List<Object> lastAbout = List.of();
    private long lastMillis;

    /** The way to the run. */
    @FunctionalInterface
    public interface Channel {

        /**
         * Gives commands that are carried out together.
         *
         * @param commands what is to be done, in order
         * @param told gets what became of each, on the event dispatch thread, soon
         */
        void send(List<Command> commands, Consumer<List<Outcome>> told);
    }

    /**
     * A desk without edits.
     *
     * @param channel the way to the run
     * @param changed told whenever what can be undone or redone is another
     */
    public EditDesk(Channel channel, Runnable changed) {
        this(channel, changed, () -> System.nanoTime() / 1_000_000);
    }

    EditDesk(Channel channel, Runnable changed, LongSupplier millis) {
        this.channel = channel;
        this.changed = changed;
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
        int now = gestureOf(commands);
        int sentIn = era;
        channel.send(commands, outcomes -> {
            if (sentIn == era) {
                remember(now, outcomes);
            }
        });
    }

    /** A new gesture, unless a hand holds on or the commands repeat the last ones. */
    private int gestureOf(List<Command> commands) {
        List<Object> about = commands.stream().map(command -> new Step(command, List.of()).about()).toList();
        long now = millis.getAsLong();
        boolean repeated = about.equals(lastAbout) && now - lastMillis <= REPEAT_MILLIS && commands.stream().allMatch(Step::repeats);
        if (!held && !repeated) {
            gesture++;
        }
        lastAbout = about;
        lastMillis = now;
        return gesture;
    }

    private void remember(int sentAs, List<Outcome> outcomes) {
        List<Step> steps = outcomes.stream().filter(outcome -> outcome.refusal().isEmpty())
                .map(outcome -> new Step(outcome.command(), outcome.undo())).filter(step -> !step.isNothing()).toList();
        noteFork(outcomes);
        if (!steps.isEmpty()) {
            CommandEdit edit = new CommandEdit(sentAs, steps, this::replay);
            history.addEdit(edit);
            if (history.holds(edit)) {
                chronicle.add(outcomes.get(0).tick(), edit, true);
            }
            changed.run();
        }
    }

    private void replay(CommandEdit edit, boolean done, List<Command> commands) {
        if (!history.isQuiet()) {
            int sentIn = era;
            channel.send(commands, outcomes -> {
                if (sentIn == era) {
                    replayed(edit, done, outcomes);
                }
            });
        }
    }

    private void replayed(CommandEdit edit, boolean done, List<Outcome> outcomes) {
        if (outcomes.stream().anyMatch(outcome -> outcome.refusal().isEmpty())) {
            noteFork(outcomes);
            if (!done) {
                news.ifPresent(told -> told.undone(chronicle.begun(edit)));
            }
            chronicle.add(outcomes.get(0).tick(), edit, done);
        } else {
            history.takeBack(edit, done);
            changed.run();
        }
    }

    private void noteFork(List<Outcome> outcomes) {
        if (outcomes.stream().anyMatch(outcome -> outcome.refusal().isEmpty()) && chronicle.fork()) {
            news.ifPresent(told -> told.forked(history.later().size()));
        }
    }

    /**
     * Sets who is told what becomes of edits.
     *
     * @param told on the event dispatch thread
     */
    public void tell(EditNews told) {
        news = Optional.of(told);
    }

    /**
     * The run was taken to another moment: edits after it can be redone, and come by themselves when the run comes to them.
     *
     * @param tick after which the run stands
     */
    public void travelled(long tick) {
        assert EventQueue.isDispatchThread();
        seal();
        if (chronicle.goTo(tick)) {
            changed.run();
        }
    }

    /**
     * The run goes on, maybe past edits that were made before it was taken back.
     *
     * @param tick it has come to
     */
    public void passed(long tick) {
        if (chronicle.goOn(tick)) {
            changed.run();
        }
    }

    /** The run begins anew, with all edits as if they had always been there. */
    public void restarted() {
        assert EventQueue.isDispatchThread();
        seal();
        chronicle.beginAnew();
        changed.run();
    }

    /**
     * Remembers an edit that has been made by beginning anew.
     *
     * @param edit can be undone
     */
    public void add(UndoableEdit edit) {
        restarted();
        history.addEdit(edit);
        changed.run();
    }

    @Override
    public void begin() {
        seal();
        held = true;
    }

    @Override
    public void end() {
        seal();
        held = false;
    }

    /** Keeps what was done from growing further: what comes is another edit. To be called when the scenario has been saved. */
    public void seal() {
        assert EventQueue.isDispatchThread();
        gesture++;
        lastAbout = List.of();
    }

    /** Forgets all edits, because they were another scenario's. */
    public void forget() {
        assert EventQueue.isDispatchThread();
        era++;
        seal();
        chronicle.clear();
        history.discardAllEdits();
        changed.run();
    }

    /** Takes the last edit back, if there is one. */
    public void undo() {
        move(history.canUndo(), history::undo);
    }

    /** Does the edit again that was taken back last, if there is one. */
    public void redo() {
        move(history.canRedo(), history::redo);
    }

    private void move(boolean possible, Runnable way) {
        assert EventQueue.isDispatchThread();
        seal();
        if (possible) {
            way.run();
            changed.run();
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
