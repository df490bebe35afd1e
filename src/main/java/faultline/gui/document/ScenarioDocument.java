package faultline.gui.document;

import faultline.control.ControllerState;
import faultline.engine.ControllerFactory;
import faultline.engine.Journal;
import faultline.gui.change.Rename;
import faultline.gui.change.SetupEditor;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * A scenario that is being edited, its file, and what the file holds. It is edited by the results of commands, so it
 * never waits for the run. Event dispatch thread only, except for {@link #initial}.
 */
final class ScenarioDocument {

    private volatile Scenario initial;
    private SetupEditor editor;
    private FileState onDisk;
    /** Null if commands have been executed since it was made. */
    private Scenario edited;
    /** The number of times that commands were sent whose results are not known yet. */
    private int unanswered;
    /** The editor with all events of the run on the timeline while the run is moved before one of them, else null. */
    private SetupEditor moved;

    private final Renames renames = new Renames();

    /** The file of a scenario. The document after a restart has that of the one before, so a save may end after it. */
    private static final class FileState {
        /** Null for none. */
        private Path file;
        /** What the file holds, null if that is not known or cannot be read. */
        private Scenario saved;
        /** What the file may hold when a save replaces it without a question, null for nothing. */
        private Scenario replaceable;
    }

    /**
     * Creates a document without edits: its file, null for none; the scenario that the file holds, null for none; and
     * that at the start of the run.
     */
    ScenarioDocument(Path file, Scenario saved, Scenario initial) {
        this.onDisk = new FileState();
        savedTo(file, saved);
        this.initial = initial;
        this.edited = initial;
        this.editor = new SetupEditor(initial.setup());
    }

    Scenario initial() {
        return initial;
    }

    Optional<Path> file() {
        return Optional.ofNullable(onDisk.file);
    }

    Optional<Scenario> saved() {
        return Optional.ofNullable(onDisk.saved);
    }

    /** Returns the scenario as edited by all commands, including those that are later than the tick of a moved run. */
    Scenario edited() {
        if (edited == null) {
            edited = withPossibleExpectation(initial.withSetup(editor.setup()));
        }
        return edited;
    }

    /** Returns a scenario without expected states that no controller of its run has. */
    private static Scenario withPossibleExpectation(Scenario scenario) {
        List<ControllerState> states = ControllerFactory.statesInRun(scenario.setup());
        return states.isEmpty()
                ? scenario
                : scenario.withExpectation(scenario.expectation().withStatesIn(states));
    }

    /**
     * Changes the edited scenario. Commands of the run stay commands of the run, except for events that the change
     * removes from the timeline.
     */
    void change(UnaryOperator<Scenario> change) {
        Scenario base = initial.withSetup(initial.setup().withTimeline(editor.timeline()));
        Scenario changed = change.apply(base);
        editor = editor.rebased(changed.setup());
        initial = withRecord(changed.withSetup(editor.initialSetup()));
        edited = null;
    }

    /**
     * Changes the edited scenario for a restart: all commands of the run become part of it, so that their ticks no
     * longer matter, and the document has no edits.
     */
    void changeForRestart(UnaryOperator<Scenario> change) {
        // With the expected states that the edited scenario hides: undo of the controller may make them possible.
        initial = withRecord(change.apply(initial.withSetup(editor.setup())));
        editor = editor.restarted(initial.setup());
        edited = null;
    }

    /** Returns whether commands that the run has executed at tick 0 change the setup. */
    boolean changesSetupAtStart() {
        return editor.changesSetupAtStart();
    }

    /** Returns {@link #changesSetupAtStart}, or true while the results of some commands are not known yet. */
    boolean mayChangeSetupAtStart() {
        return awaitsCommands() || changesSetupAtStart();
    }

    /**
     * Redoes or undoes changes of an earlier run in the setup at the start. The document then has no commands of the
     * run any more, except for events.
     */
    void changeStart(List<CommandResult> changes, boolean redone) {
        editor = editor.withEarlierChanges(changes, redone);
        initial = withRecord(initial.withSetup(editor.initialSetup()));
        edited = null;
    }

    /** Returns the changes of ids so far. */
    Renames renames() {
        return renames;
    }

    /** Changes the id of a sensor or an obstacle in the edited scenario and in the commands of the run. */
    void rename(Rename rename) {
        renames.add(rename);
        editor = editor.renamed(rename);
        initial = withRecord(rename.rename(initial));
        edited = null;
    }

    /** Returns an earlier command of the timeline with the id that its sensor or obstacle has now, if it is there. */
    Command presentCommand(Command command) {
        return renames.presentCommand(command, edited().setup());
    }

    /** Returns the result of an event that the run has executed, with what undoes it in the present run. */
    CommandResult presentResult(CommandResult event) {
        return editor.presentResult(event);
    }

    /** Returns commands of the run with the ids that their sensors and obstacles have in the edited scenario. */
    List<Command> named(List<Command> commands) {
        List<String> ids = edited().setup().robot().sensorIds();
        return commands.stream().map(command -> renames.ofRun(command, ids)).toList();
    }

    /** Returns the result of a command of the run with the ids of the edited scenario. */
    CommandResult named(CommandResult result) {
        return renames.ofRun(result, edited().setup().robot().sensorIds());
    }

    /** Returns a scenario as the record of a run again, if the file holds one with this setup. */
    private Scenario withRecord(Scenario changed) {
        Scenario saved = onDisk.saved;
        boolean recorded = saved != null && saved.recorded() && saved.setup().equals(changed.setup());
        return recorded
                ? new Scenario(changed.name(), changed.description(), true, changed.setup(), changed.expectation())
                : changed;
    }

    /** Returns the setup at the start of the run, and the commands executed since then or still ahead. */
    Journal journal(long ticks) {
        renames.journalMade();
        return moved == null
                ? new Journal(initial.setup(), editor.entries(), ticks)
                : new Journal(withTimelineOf(moved).setup(), moved.entries(), ticks);
    }

    private Scenario withTimelineOf(SetupEditor other) {
        return initial.withSetup(initial.setup().withTimeline(other.initialTimeline()));
    }

    /** Returns whether the file holds another scenario than the edited one, or none. */
    boolean isChanged() {
        return !edited().equals(onDisk.saved);
    }

    void commandsSent() {
        unanswered++;
    }

    void commandsAnswered() {
        unanswered--;
    }

    /** Returns whether the results of some commands are not known yet. */
    boolean awaitsCommands() {
        return unanswered > 0;
    }

    void commandsExecuted(List<CommandResult> results) {
        results.stream().filter(result -> result.refusal().isEmpty()).forEach(editor::add);
        edited = null;
    }

    /**
     * Changes the scenario at a tick as a command of an earlier tick did, although the run has executed another one,
     * null for none, since its timeline has changed the same thing.
     */
    void changedLater(long tick, CommandResult change, CommandResult executed) {
        editor.add(tick, change, executed);
        edited = null;
    }

    /** Notes that commands that have been executed undo events of the run. */
    void noteUndo(List<CommandResult> undone, List<CommandResult> results) {
        editor.noteUndo(undone, results);
    }

    /** Drops the events later than a tick that change nothing any more. The edited scenario remains the same. */
    void dropEventsWithoutEffectAfter(long tick) {
        editor.dropEventsWithoutEffectAfter(tick);
    }

    /** Makes all events of the run commands of the timeline. The edited scenario remains the same. */
    void putEventsOnTimeline() {
        editor = editor.withEventsOnTimeline();
        initial = withTimelineOf(editor);
    }

    /**
     * Prepares a move of the run to a tick. If an event is later than the commands for the next tick, all events of the
     * run become commands of the timeline with the move, so that they are kept whatever is executed at the earlier
     * tick.
     */
    void prepareMoveTo(long tick) {
        moved = editor.hasEventsAfter(tick + 1) ? editor.withEventsOnTimeline() : null;
    }

    /** Prepares a simulation of the run up to its present tick. */
    void prepareResimulation() {
        moved = null;
    }

    /** Follows the run to a tick; returns whether all events of the run have become commands of the timeline. */
    boolean runRepositioned(long tick) {
        renames.journalReplayed();
        boolean onTimeline = moved != null;
        if (onTimeline) {
            editor = moved;
            initial = withTimelineOf(editor);
            moved = null;
        }
        editor.moveTo(tick);
        return onTimeline;
    }

    /** Returns what a save may replace without a question; empty for nothing. */
    Optional<Scenario> replaceable() {
        return Optional.ofNullable(onDisk.replaceable);
    }

    /**
     * Sets what another program has written to the file, null if it cannot be read. A save replaces it without a
     * question only after {@link #allowReplacement}.
     */
    void setSaved(Scenario found) {
        onDisk.saved = found;
    }

    /** Lets a save replace what the file holds: the user knows it and keeps the edited scenario. */
    void allowReplacement() {
        onDisk.replaceable = onDisk.saved;
    }

    void savedTo(Path newFile, Scenario newSaved) {
        onDisk.file = newFile;
        onDisk.saved = newSaved;
        onDisk.replaceable = newSaved;
    }

    /**
     * Continues a document that was edited to this one: with its file, also if a save of it ends later, its hidden
     * commands and the states that an earlier controller is expected to reach.
     */
    void continueFrom(ScenarioDocument other) {
        onDisk = other.onDisk;
        if (initial.expectation().equals(other.edited().expectation())) {
            initial = initial.withExpectation(other.initial.expectation());
            edited = null;
        }
        editor = other.editor.restarted(initial.setup());
        renames.continueFrom(other.renames);
    }

    /** Returns whether this is a document or continues it after restarts. */
    boolean continues(ScenarioDocument other) {
        return onDisk == other.onDisk;
    }

    /** Returns the file, or the name of the scenario if it has none. */
    Path displayPath() {
        return file().orElseGet(() -> Path.of(FileNames.forScenario(initial.name())));
    }
}
