package faultline.gui.document;

import faultline.control.ControllerState;
import faultline.engine.ControllerFactory;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.gui.change.ObstacleOrigins;
import faultline.gui.change.Rename;
import faultline.gui.change.SensorReference;
import faultline.gui.change.SetupEditor;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

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
    /** The changes of ids of sensors so far, with their reverses, in order. */
    private final List<Rename> sensorRenames = new ArrayList<>();

    private final ObstacleRenames obstacleRenames = new ObstacleRenames();

    /** The file of a scenario. The document after a restart has that of the one before, so a save may end after it. */
    private static final class FileState {
        /** Null for none. */
        private Path file;
        /** What the file holds, null if that is not known or cannot be read. */
        private Scenario saved;
        /** What the file may hold when a save replaces it without a question, null for nothing. */
        private Scenario replaceable;
    }

    /** The changes of ids of obstacles so far, with their reverses, in order, and those that the run lacks. */
    private static final class ObstacleRenames {
        private final List<Rename> all = new ArrayList<>();
        /** The number of changes that the journal had when it was made last. */
        private int inJournal;
        /** The number of changes that the run has. */
        private int inRun;
        /** The number of changes that the views have. */
        private int inViews;

        /** Returns the changes that lead from the ids after a number of changes to those after another number. */
        private List<Rename> between(int from, int to) {
            return from <= to ? List.copyOf(all.subList(from, to)) : Rename.inverse(all.subList(to, from));
        }

        private Command named(Command command, int from, int to) {
            Command named = command;
            for (Rename rename : between(from, to)) {
                named = rename.rename(named);
            }
            return named;
        }

        /** Continues the changes of a document whose edited scenario a new run has. */
        void continueFrom(ObstacleRenames other) {
            all.addAll(other.all);
            inJournal = all.size();
            inRun = all.size();
            inViews = other.inViews;
        }
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
        initial = withRecord(changed.withSetup(changed.setup().withTimeline(editor.initialTimeline())));
        edited = null;
    }

    /**
     * Changes the edited scenario for a restart: all commands of the run become part of it, so that their ticks no
     * longer matter, and the document has no edits.
     */
    void changeForRestart(UnaryOperator<Scenario> change) {
        initial = withRecord(change.apply(edited()));
        editor = editor.restarted(initial.setup());
        edited = null;
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

    /** Returns what gives results with the present ids those that they have after the changes of ids to come. */
    Supplier<List<CommandResult>> followRenames(List<CommandResult> results) {
        int sensors = sensorRenames.size();
        int obstacles = obstacleRenames();
        return () -> {
            List<Rename> since = new ArrayList<>(sensorRenames.subList(sensors, sensorRenames.size()));
            since.addAll(obstacleRenames.between(obstacles, obstacleRenames()));
            List<CommandResult> followed = new ArrayList<>(results);
            since.forEach(rename -> followed.replaceAll(rename::rename));
            return followed;
        };
    }

    /** Changes the id of a sensor or an obstacle in the edited scenario and in the commands of the run. */
    void rename(Rename rename) {
        (rename.isOfSensor() ? sensorRenames : obstacleRenames.all).add(rename);
        editor = editor.renamed(rename);
        initial = withRecord(rename.rename(initial));
        edited = null;
    }

    /**
     * Returns what a sensor is called in a list of the ids of a robot, given an id that it has, had before or will have
     * there: a session may have the ids from before a renaming. Of an id that several sensors had, the last one counts.
     * The id itself if the list lacks the sensor.
     */
    String presentId(String id, List<String> ids) {
        return presentId(id, ids, sensorRenames);
    }

    private static String presentId(String id, Collection<String> ids, List<Rename> renames) {
        int count = renames.size();
        List<Rename> back = Rename.inverse(renames);
        return Stream.concat(
                        IntStream.rangeClosed(0, count).mapToObj(last -> renames.subList(count - last, count)),
                        Stream.of(back))
                .map(changes -> renamedUntilIn(ids, id, changes))
                .filter(ids::contains)
                .findFirst()
                .orElse(id);
    }

    private static String renamedUntilIn(Collection<String> ids, String id, List<Rename> changes) {
        String result = id;
        for (Rename change : changes) {
            result = ids.contains(result) ? result : change.rename(result);
        }
        return result;
    }

    /** Returns an earlier command of the timeline with the id that its sensor or obstacle has now, if it is there. */
    Command presentCommand(Command command) {
        SimulationSetup setup = edited().setup();
        Set<String> ids = ObstacleOrigins.idsIn(setup);
        return ObstacleOrigins.subject(command)
                .map(id -> Rename.ofObstacle(id, presentId(id, ids, obstacleRenames.all))
                        .rename(command))
                .orElseGet(() -> named(command, setup.robot().sensorIds()));
    }

    /** Returns the number of changes of ids of obstacles. */
    int obstacleRenames() {
        return obstacleRenames.all.size();
    }

    /**
     * Returns a command of the edited scenario after a number of changes of ids of obstacles with the ids of the run,
     * given those of its sensors.
     */
    Command inRun(Command command, int renames, List<String> sensorIds) {
        return named(obstacleRenames.named(command, renames, obstacleRenames.inRun), sensorIds);
    }

    /** Returns a command with the id that its sensor has in a list of the ids of a robot. */
    private Command named(Command command, List<String> ids) {
        return SensorReference.in(command)
                .map(id -> Rename.ofSensor(id, presentId(id, ids)).rename(command))
                .orElse(command);
    }

    /** Returns a journal of the run with the ids that obstacles have in the journal that was made last. */
    Journal named(Journal ofRun) {
        Journal named = ofRun;
        for (Rename rename : obstacleRenames.between(obstacleRenames.inRun, obstacleRenames.inJournal)) {
            named = rename.rename(named);
        }
        return named;
    }

    /** Returns commands of the run with the ids that their sensors and obstacles have in the edited scenario. */
    List<Command> named(List<Command> commands) {
        List<String> ids = edited().setup().robot().sensorIds();
        return commands.stream()
                .map(command -> named(obstacleRenames.named(command, obstacleRenames.inRun, obstacleRenames()), ids))
                .toList();
    }

    /** Returns the result of a command of the run with the ids of the edited scenario. */
    CommandResult named(CommandResult result) {
        List<String> ids = edited().setup().robot().sensorIds();
        CommandResult named = SensorReference.in(result.command())
                .map(id -> Rename.ofSensor(id, presentId(id, ids)).rename(result))
                .orElse(result);
        for (Rename rename : obstacleRenames.between(obstacleRenames.inRun, obstacleRenames())) {
            named = rename.rename(named);
        }
        return named;
    }

    /** Returns a command of the views with the id that its obstacle has in the edited scenario. */
    Command ofViews(Command command) {
        return obstacleRenames.named(command, obstacleRenames.inViews, obstacleRenames());
    }

    /** Returns the id that an obstacle of the views has in the edited scenario. */
    String ofViews(String id) {
        return renamed(id, obstacleRenames.between(obstacleRenames.inViews, obstacleRenames()));
    }

    /**
     * Returns what gives the obstacles of the views the ids that they have in the run, which they have from now on;
     * empty if they have them already.
     */
    Optional<UnaryOperator<String>> takeRenames() {
        List<Rename> taken = obstacleRenames.between(obstacleRenames.inViews, obstacleRenames.inRun);
        obstacleRenames.inViews = obstacleRenames.inRun;
        return taken.isEmpty() ? Optional.empty() : Optional.of(id -> renamed(id, taken));
    }

    private static String renamed(String id, List<Rename> changes) {
        String renamed = id;
        for (Rename change : changes) {
            renamed = change.renameObstacle(renamed);
        }
        return renamed;
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
        obstacleRenames.inJournal = obstacleRenames();
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
        obstacleRenames.inRun = obstacleRenames.inJournal;
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
        sensorRenames.addAll(other.sensorRenames);
        obstacleRenames.continueFrom(other.obstacleRenames);
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
