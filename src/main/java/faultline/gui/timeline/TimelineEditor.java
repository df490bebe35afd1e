package faultline.gui.timeline;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.change.TimelineEvents;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.SetupChange;
import faultline.gui.edit.UndoController;
import faultline.gui.text.Messages;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;

/** Changes the timeline of the open scenario; every change can be undone. Event dispatch thread only. */
public final class TimelineEditor {

    private final Workspace workspace;
    private final RunController run;
    private final UndoController undo;
    private final Consumer<String> notes;
    private TimelineModel model = TimelineModel.EMPTY;
    private TimelineItem clipboard;
    /** The item that the last undo or redo restored, until a view has selected it; null for none. */
    private TimelineItem restored;
    /** The item that was changed last, as it is since; null for none. */
    private TimelineItem lastChanged;
    /** Stands for that item in its gesture. */
    private Object lastTarget = new Object();

    /**
     * Creates an editor of the scenario of a workspace; {@code notes} receives sentences in the current language about
     * why nothing has changed.
     */
    public TimelineEditor(Workspace workspace, RunController run, UndoController undo, Consumer<String> notes) {
        this.workspace = workspace;
        this.run = run;
        this.undo = undo;
        this.notes = notes;
    }

    /** Returns the timeline of the open scenario; the same object as before if nothing has changed. */
    public TimelineModel model() {
        setup().filter(now -> !model.isOf(now.timeline(), now.dt()))
                .ifPresent(now -> model = TimelineModel.of(now.timeline(), now.dt()));
        return model;
    }

    private Optional<SimulationSetup> setup() {
        return workspace.scenario().map(scenario -> scenario.setup());
    }

    /** Returns the time of the tick nearest to a time, seconds. */
    double roundToTick(double time) {
        return setup().map(now -> now.timeOf(Math.round(Math.max(0, time) / now.dt())))
                .orElse(time);
    }

    /** Returns the length of a tick, seconds. */
    double tickLength() {
        return setup().map(SimulationSetup::dt).orElse(0.01);
    }

    /** Returns the robot at the start of the run. */
    RobotSpec robot() {
        return setup().map(SimulationSetup::robot).orElse(RobotSpec.DEFAULT);
    }

    /**
     * Returns the controller that the scenario has at a time; empty if it is an external controller, which cannot be
     * changed during a run.
     */
    Optional<ControllerSpec.BuiltIn> controllerAt(double time) {
        return setup().map(SimulationSetup::controller)
                .filter(ControllerSpec.BuiltIn.class::isInstance)
                .map(first -> model().items().stream()
                        .filter(item -> item.start() <= time)
                        .map(TimelineItem::command)
                        .filter(Command.ConfigureController.class::isInstance)
                        .map(command -> ((Command.ConfigureController) command).controller())
                        .reduce((ControllerSpec.BuiltIn) first, (earlier, later) -> later));
    }

    /**
     * Adds an item, and reports if it repeats a fault; undo selects {@code before}, the item that was selected, which
     * may be null.
     */
    void add(TimelineItem item, TimelineItem before) {
        if (model().items().stream().anyMatch(item::repeats)) {
            notes.accept(Messages.get("timeline.again", TimelineText.title(item)));
        }
        commit("timeline.add", item, model().with(item), new Object(), new Selections(before, item));
    }

    /** Replaces an item, given its index; changes of the same item in quick succession are one edit. */
    void replace(int index, TimelineItem changed) {
        TimelineItem before = model().items().get(index);
        // A change of the times may change the index.
        if (!before.equals(lastChanged)) {
            lastTarget = new Object();
        }
        lastChanged = changed;
        commit("timeline.change", changed, model().with(index, changed), lastTarget, new Selections(before, changed));
    }

    void remove(int index) {
        TimelineItem item = model().items().get(index);
        commit("timeline.remove", item, model().without(index), new Object(), new Selections(item, null));
    }

    void copy(int index) {
        clipboard = model().items().get(index);
    }

    /** Returns the item that was copied last, with the present id of its sensor or obstacle; empty if there is none. */
    Optional<TimelineItem> clipboard() {
        return Optional.ofNullable(clipboard).map(this::presentItem);
    }

    /** Returns an item of an earlier timeline with the present id of its sensor or obstacle. */
    TimelineItem presentItem(TimelineItem item) {
        return new TimelineItem(workspace.presentCommand(item.command()), item.start(), item.end());
    }

    /** Returns whether the scenario has the sensor or the obstacle that an item is about. */
    boolean hasSubjectOf(TimelineItem item) {
        return workspace.hasSubjectOf(item.command());
    }

    /** Reports that an item is not pasted because the scenario has no sensor or obstacle that it is about. */
    void reportNoSubject(TimelineItem item) {
        notes.accept(Messages.get("timeline.paste.noSubject", TimelineText.title(item)));
    }

    /** Reports that an item is not pasted because a lane cannot have it. */
    void reportMisplaced(TimelineItem item, Lane lane) {
        notes.accept(Messages.get("timeline.paste.misplaced", TimelineText.title(item), lane.label()));
    }

    /** The items that are selected after an undo and after a redo, null for none. */
    private record Selections(TimelineItem afterUndo, TimelineItem afterRedo) {}

    /** A change of the timeline from one to another. */
    private record TimelineChange(
            TimelineEditor editor, List<TimedCommand> before, List<TimedCommand> after, Selections selections)
            implements SetupChange {
        @Override
        public void undo() {
            editor.restore(after, before, selections.afterUndo());
        }

        @Override
        public void redo() {
            editor.restore(before, after, selections.afterRedo());
        }

        @Override
        public boolean isNoOp() {
            return after.equals(before);
        }

        @Override
        public SetupChange mergedWith(SetupChange later) {
            return later instanceof TimelineChange next
                    ? new TimelineChange(
                            editor,
                            before,
                            next.after,
                            new Selections(selections.afterUndo(), next.selections.afterRedo()))
                    : SetupChange.super.mergedWith(later);
        }
    }

    /** Changes the timeline; changes of one target in quick succession are one edit. */
    private void commit(String key, TimelineItem item, List<TimedCommand> after, Object target, Selections selections) {
        List<TimedCommand> before = model().commands();
        if (!after.equals(before)) {
            setTimeline(after);
            // Events of the run stay behind the other commands.
            undo.addSetupEdit(
                    () -> Messages.get(key, TimelineText.title(item)),
                    target,
                    new TimelineChange(this, before, model().commands(), selections));
        }
    }

    /**
     * Changes the timeline from one to another. Events that have been added or removed in between, because the run was
     * moved to another tick, stay so.
     */
    private void restore(List<TimedCommand> from, List<TimedCommand> to, TimelineItem selected) {
        List<TimedCommand> before = events(from);
        List<TimedCommand> after = events(to);
        List<TimedCommand> wanted = withDifference(events(model().commands()), before, after);
        setTimeline(withDifference(to, after, wanted));
        restored = selected;
    }

    private static List<TimedCommand> events(List<TimedCommand> timeline) {
        return timeline.stream()
                .filter(timed -> TimelineEvents.isEvent(timed.command()))
                .toList();
    }

    /** Returns a timeline without what the second list lacks of the first one, and with what the first one lacks. */
    private static List<TimedCommand> withDifference(
            List<TimedCommand> timeline, List<TimedCommand> first, List<TimedCommand> second) {
        List<TimedCommand> kept = TimelineEvents.difference(timeline, TimelineEvents.difference(first, second));
        return Stream.concat(kept.stream(), TimelineEvents.difference(second, first).stream())
                .toList();
    }

    /**
     * Returns, once, the item that the last undo or redo brought back, with the present id of its sensor or obstacle;
     * empty if there is none.
     */
    Optional<TimelineItem> takeRestored() {
        Optional<TimelineItem> result = Optional.ofNullable(restored).map(this::presentItem);
        restored = null;
        return result;
    }

    private void setTimeline(List<TimedCommand> commands) {
        run.change(old -> old.withSetup(old.setup().withTimeline(commands)));
    }
}
