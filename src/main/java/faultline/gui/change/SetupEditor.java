package faultline.gui.change;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.change.Reversal.UndoCommand;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Applies executed commands to a setup. Changes of obstacles, of the platform, of the controller and of the sensors'
 * settings hold from the start; switching a sensor, injecting a fault and repairing it are added to the timeline at
 * their time. When the run is moved to an earlier tick, the later commands are kept until another one is executed
 * there; events are put on the timeline before and are not lost.
 *
 * <p>A change of an obstacle that the timeline places holds from then on. The timeline's commands about an obstacle
 * that has been removed are hidden until it is placed again.
 */
public final class SetupEditor {

    /** The setup before the commands, with the hidden commands in its timeline. */
    private final SimulationSetup base;

    /** The obstacles before the commands. */
    private final EditedObstacles baseObstacles;

    private final ExecutedChanges entries;
    /** What a command restores that undoes the last command with this inverse that has not been undone. */
    private final Map<UndoCommand, Reversal> reversals = new HashMap<>();
    /** The same for edits that are part of the base, whose ticks are those of an earlier run. */
    private final Map<UndoCommand, Reversal> baseReversals;
    /**
     * The latest tick of the events that changes of the setup have removed from the entries; another may restore them.
     */
    private long lastRemovedEvent = Long.MIN_VALUE;

    /** The sensors that changes of the setup have removed in this run. */
    private RemovedSensors removedSensors = new RemovedSensors();

    private EditedSetup edited;

    public SetupEditor(SimulationSetup setup) {
        this(new EditedObstacles(setup), Map.of());
    }

    /**
     * Creates an editor without edits.
     *
     * @param obstacles the obstacles of its setup
     * @param reversals what commands restore that undo earlier edits
     */
    private SetupEditor(EditedObstacles obstacles, Map<UndoCommand, Reversal> reversals) {
        this.base = obstacles.base();
        this.baseObstacles = obstacles;
        this.baseReversals = Map.copyOf(reversals);
        this.entries = new ExecutedChanges();
        reset();
    }

    private SetupEditor(SetupEditor other) {
        this.base = other.base;
        this.baseObstacles = other.baseObstacles;
        this.baseReversals = other.baseReversals;
        this.entries = new ExecutedChanges();
        this.edited = other.edited.copy();
        this.removedSensors = other.removedSensors;
        this.lastRemovedEvent = other.lastRemovedEvent;
    }

    /** Copies an editor with another id of a sensor or an obstacle. */
    private SetupEditor(SetupEditor other, Rename rename) {
        this.base = rename.rename(other.base);
        this.baseObstacles = other.baseObstacles.renamed(rename);
        this.baseReversals = new HashMap<>();
        other.baseReversals.forEach(
                (undo, reversal) -> baseReversals.put(undo.renamed(rename), reversal.renamed(rename)));
        this.removedSensors = other.removedSensors.renamed(rename);
        this.lastRemovedEvent = other.lastRemovedEvent;
        this.entries = other.entries.renamed(rename);
        replay();
    }

    private void reset() {
        edited = new EditedSetup(base, baseObstacles);
        reversals.clear();
    }

    private void replay() {
        reset();
        entries.all().forEach(entry -> apply(entry.change()));
    }

    /**
     * Applies an executed command. Commands that the run had not executed at that time are dropped, and so is a command
     * about a sensor that has been removed while the run was busy with the command.
     */
    public void add(CommandResult result) {
        add(result.tick(), EditedSetup.withoutSwitch(result), result);
    }

    /**
     * Applies, at a tick, the change that a command of an earlier tick made, for which the run has executed another
     * command, null for none. If it has executed none, later commands of the run remain, except for what undoes or
     * redoes the same change there without the run.
     */
    public void add(long tick, CommandResult change, CommandResult executed) {
        if (!SensorReference.isOn(edited.robot(), change.command())) {
            return;
        }
        if (entries.execute(new ExecutedChange(tick, change, executed))) {
            apply(change);
        } else {
            replay();
        }
    }

    /**
     * Drops the events later than a tick that change nothing any more. A new edit at the tick has dropped the redo that
     * could give them an effect again.
     */
    public void dropEventsWithoutEffectAfter(long tick) {
        entries.dropEventsWithoutEffectAfter(tick);
    }

    /** Follows the run to another tick, where the commands for the next one have been executed. */
    public void moveTo(long tick) {
        entries.moveTo(tick + 1);
    }

    /** Returns whether the setup has been changed before the first tick, and no command is later. */
    public boolean changesSetupAtStart() {
        return entries.all().stream().allMatch(entry -> entry.tick() <= 1 || entry.isEventWithoutEffectNow())
                && entries.all().stream().anyMatch(entry -> !entry.isEvent() && !isHidden(entry));
    }

    /** Returns whether the sensor of a change has been removed, so that the run does not execute the change. */
    private boolean isHidden(ExecutedChange entry) {
        return removedSensors.isAbout(entry.change().command());
    }

    /** Returns the edited setup. Changes that leave no room for the robot at its start pose are omitted. */
    public SimulationSetup setup() {
        return edited.withTimeline(timeline());
    }

    /**
     * Returns the timeline with the commands that belong to a time. Commands that changed nothing are omitted, those of
     * one tick that cancel each other, and the hidden commands.
     */
    public List<TimedCommand> timeline() {
        List<TimedCommand> result = new ArrayList<>(edited.obstacles().timeline());
        entries.events().forEach(event -> result.add(timedCommand(event)));
        return result;
    }

    private TimedCommand timedCommand(CommandResult event) {
        return new TimedCommand(base.timeOf(event.tick()), event.command());
    }

    /** Returns the timeline before the executed commands, without what was hidden then. */
    public List<TimedCommand> initialTimeline() {
        return baseObstacles.timeline();
    }

    /** Returns the setup before the executed commands, without what was hidden then. */
    public SimulationSetup initialSetup() {
        return base.withTimeline(initialTimeline());
    }

    /** Returns an editor of the edited setup, without edits, that hides the same commands and can undo the edits. */
    public SetupEditor restarted(SimulationSetup newSetup) {
        Map<UndoCommand, Reversal> all = new HashMap<>(baseReversals);
        reversals.forEach((undo, reversal) -> all.merge(undo, reversal, (earlier, later) -> later.after(earlier)));
        return restarted(newSetup, all);
    }

    private SetupEditor restarted(SimulationSetup newSetup, Map<UndoCommand, Reversal> newReversals) {
        EditedObstacles obstacles = edited.obstacles();
        return new SetupEditor(obstacles.rebased(newSetup, obstacles.hidden()), newReversals);
    }

    /**
     * Returns an editor of a setup with the executed commands and changes that redo or undo edits of an earlier run. It
     * has no executed commands, except for events.
     */
    public SetupEditor withEarlierChanges(List<CommandResult> changes, boolean redone) {
        SetupEditor earlier = new SetupEditor(this);
        earlier.reset();
        // These undo each other, except for those about a sensor that has been deleted and restored in between.
        entries.executed().forEach(entry -> earlier.apply(entry.change()));
        earlier.reversals.clear();
        Map<UndoCommand, Reversal> undone = new HashMap<>(baseReversals);
        // The command that redoes an edit may be the same as one that undoes another.
        changes.stream()
                .filter(earlier.edited::hasSubjectOf)
                .forEach(change -> earlier.apply(change, redone ? earlier.reversals : undone));
        SetupEditor result = redone ? earlier.restarted(earlier.setup()) : earlier.restarted(earlier.setup(), undone);
        result.lastRemovedEvent = lastRemovedEvent;
        result.entries.addFrom(entries, ExecutedChange::isEvent);
        return result;
    }

    /**
     * Returns an editor of another setup with the executed commands, except for those about sensors and obstacles that
     * the other setup lacks, what undoes or redoes these, and events that are not on its timeline. Settings of a
     * removed sensor are hidden instead; if it has returned as edited, the start has the sensor from before the
     * settings.
     */
    public SetupEditor rebased(SimulationSetup newSetup) {
        List<TimedCommand> timeline = new ArrayList<>(edited.obstacles().withoutEdits(newSetup.timeline()));
        Set<CommandResult> events = takeEvents(timeline);
        SetupEditor result = rebased(newSetup, timeline, events).withLaterEventsOnTimeline();
        result.lastRemovedEvent = entries.events().stream()
                .filter(event -> !events.contains(event))
                .mapToLong(CommandResult::tick)
                .reduce(lastRemovedEvent, Math::max);
        return result;
    }

    /** Returns whether an event of the run is, or was before a change of the setup, later than a tick. */
    public boolean hasEventsAfter(long tick) {
        return lastRemovedEvent > tick || entries.hasEventsAfter(tick);
    }

    /**
     * Returns an editor of the same setup in which all events of the run are commands of the timeline, except for those
     * that change nothing any more: these stay in the run.
     */
    public SetupEditor withEventsOnTimeline() {
        return withEventsOnTimeline(List.of());
    }

    /**
     * Returns an editor in which the events that a moved run has not reached are commands of the timeline: events that
     * have an effect again must not be lost by an edit at an earlier tick.
     */
    private SetupEditor withLaterEventsOnTimeline() {
        return entries.later().stream()
                        .anyMatch(entry -> entry.isEvent() && !entry.change().isNoOp())
                ? withEventsOnTimeline(entries.executed())
                : this;
    }

    /** Returns an editor in which the events of all but some entries are commands of the timeline. */
    private SetupEditor withEventsOnTimeline(List<ExecutedChange> others) {
        Set<CommandResult> kept = entries.eventsWithoutEffectNow();
        others.forEach(entry -> kept.add(entry.change()));
        List<TimedCommand> timeline = new ArrayList<>(edited.obstacles().timeline());
        entries.events().stream()
                .filter(event -> !kept.contains(event))
                .map(this::timedCommand)
                .forEach(timeline::add);
        return rebased(base, edited.obstacles().withoutEdits(timeline), kept);
    }

    /** Returns an editor of another setup and timeline, with the executed commands and some of the events. */
    private SetupEditor rebased(SimulationSetup newSetup, List<TimedCommand> timeline, Set<CommandResult> events) {
        RobotSpec robot = newSetup.robot();
        SimulationSetup setup =
                newSetup.withRobot(removedSensors.returnedTo(robot)).withTimeline(timeline);
        SetupEditor result =
                new SetupEditor(baseObstacles.rebased(setup, edited.obstacles().hidden()), baseReversals);
        result.removedSensors = removedSensors.after(base.robot(), edited.robot(), robot);
        boolean sameObstacles = ObstacleOrigins.areEqual(base, result.base);
        if (sameObstacles) {
            result.takeObstacles(this);
        }
        Set<Command> reversalsOfOmitted = new HashSet<>();
        result.entries.addFrom(entries, entry -> {
            CommandResult change = entry.change();
            if (sameObstacles && ObstacleOrigins.subject(change.command()).isPresent()) {
                return true;
            }
            if (removedSensors.isReplaced(change.command(), robot)) {
                return false;
            }
            if (result.isHidden(entry) && !entry.isEvent()) {
                return true;
            }
            if (!result.edited.hasSubjectOf(change) || reversalsOfOmitted.remove(change.command())) {
                reversalsOfOmitted.addAll(change.inverse());
                return false;
            }
            return events.contains(change) || result.apply(change);
        });
        result.entries.updateEvents(result.base);
        return result;
    }

    /** Takes the edited obstacles, of which there may be many edits, and what undoes these edits. */
    private void takeObstacles(SetupEditor other) {
        edited.takeObstacles(other.edited);
        other.reversals.forEach((undo, reversal) -> {
            if (undo.origin() != null) {
                reversals.put(undo, reversal);
            }
        });
    }

    /**
     * Notes that the results of an undo, which have been applied, undo events of the run. If the timeline is changed so
     * that these have no effect any more, the undo has none either.
     */
    public void noteUndo(List<CommandResult> undone, List<CommandResult> results) {
        entries.linkUndo(undone, results);
    }

    /** Returns the result of an event that the run has executed, with what undoes it in the present run. */
    public CommandResult presentResult(CommandResult event) {
        return entries.presentResult(event);
    }

    /**
     * Removes the events of the run from a timeline, and returns those that it contained, and those that change nothing
     * any more and are on no timeline: another change may give them an effect again.
     */
    private Set<CommandResult> takeEvents(List<TimedCommand> timeline) {
        Set<CommandResult> taken = entries.eventsWithoutEffectNow();
        for (CommandResult event : entries.events()) {
            int index = timeline.lastIndexOf(timedCommand(event));
            if (index >= 0) {
                timeline.remove(index);
                taken.add(event);
            }
        }
        return taken;
    }

    /** Returns an editor whose setup and executed commands have another id of a sensor or an obstacle. */
    public SetupEditor renamed(Rename rename) {
        return new SetupEditor(this, rename);
    }

    /**
     * Returns the executed commands, including those that are later than the tick of a moved run, without the hidden
     * ones and those that undo what has no effect any more.
     */
    public List<Journal.Entry> entries() {
        return entries.all().stream()
                .filter(entry -> !isHidden(entry) && !entry.isUndoWithoutEffectNow())
                .flatMap(entry -> Stream.ofNullable(entry.executed()))
                .map(result -> new Journal.Entry(result.tick(), result.command()))
                .toList();
    }

    /**
     * Applies a command, and returns whether it changes the setup rather than belong to a time of the run. A command
     * that undoes another one, though the timeline has changed the same thing in between, restores what the setup had
     * before that one.
     */
    private boolean apply(CommandResult result) {
        return apply(result, reversals);
    }

    /** Applies a command, and removes from the reversals the one that it uses. */
    private boolean apply(CommandResult result, Map<UndoCommand, Reversal> undoable) {
        if (TimelineEvents.isEvent(result.command()) || removedSensors.isAbout(result.command())) {
            return false;
        }
        Consumer<EditedSetup> restored = edited.reversal(result);
        UndoCommand undo = undoCommand(result.tick(), result.effect());
        Optional.ofNullable(undoable.get(undo))
                .map(Reversal::restored)
                .orElseGet(() -> EditedSetup.change(result))
                .accept(edited);
        undoable.computeIfPresent(undo, (same, reversal) -> reversal.earlier());
        if (result.inverse().size() == 1) {
            UndoCommand later = undoCommand(result.tick(), result.inverse().get(0));
            reversals.put(later, new Reversal(restored, reversals.get(later)));
        }
        return true;
    }

    /** Returns a command with the origin that its obstacle has at a tick: the timeline may place one of the same id. */
    private UndoCommand undoCommand(long tick, Command command) {
        return new UndoCommand(
                command,
                ObstacleOrigins.subject(command)
                        .map(id -> edited.obstacles().originAt(tick, id))
                        .orElse(null));
    }
}
