package faultline.gui.document;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.gui.change.ObstacleOrigins;
import faultline.gui.change.Rename;
import faultline.gui.change.SensorReference;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The changes of ids of sensors and obstacles in a document so far. After a change, the run has the earlier ids until
 * it has been simulated again, and the views have them until they show a frame of the new run; so ids are translated
 * between the edited scenario, the run, its journal and the views. A sensor is found by any id that it had or will
 * have. An obstacle is not, since another one may have had that id; the changes that the run, the journal and the views
 * have are counted instead.
 */
final class Renames {

    /** The changes with their reverses, in order. */
    private final List<Rename> ofSensors = new ArrayList<>();
    /** The changes with their reverses, in order. */
    private final List<Rename> ofObstacles = new ArrayList<>();
    /** The number of changes of obstacles that the journal had when it was made last. */
    private int inJournal;
    /** The number of changes of obstacles that the run has. */
    private int inRun;
    /** The number of changes of obstacles that the views have. */
    private int inViews;

    void add(Rename rename) {
        (rename.isOfSensor() ? ofSensors : ofObstacles).add(rename);
    }

    /** Continues the changes of a document whose edited scenario a new run has. */
    void continueFrom(Renames other) {
        ofSensors.addAll(other.ofSensors);
        ofObstacles.addAll(other.ofObstacles);
        inJournal = ofObstacles.size();
        inRun = ofObstacles.size();
        inViews = other.inViews;
    }

    /** Notes that a journal has been made of the edited scenario. */
    void journalMade() {
        inJournal = ofObstacles.size();
    }

    /** Notes that the run is that of the journal that was made last. */
    void journalReplayed() {
        inRun = inJournal;
    }

    /** Returns the number of changes of ids of obstacles. */
    int changesOfObstacles() {
        return ofObstacles.size();
    }

    /** Returns what gives results with the present ids those that they have after the changes of ids to come. */
    Supplier<List<CommandResult>> follow(List<CommandResult> results) {
        int sensors = ofSensors.size();
        int obstacles = ofObstacles.size();
        return () -> {
            List<Rename> changes = new ArrayList<>(ofSensors.subList(sensors, ofSensors.size()));
            changes.addAll(since(obstacles));
            return results.stream()
                    .map(result -> renamed(result, changes, Rename::rename))
                    .toList();
        };
    }

    /** Returns what gives a sensor with its present id the one that it has after the changes of ids to come. */
    Supplier<String> followSensor(String id) {
        int before = ofSensors.size();
        return () -> renamed(id, ofSensors.subList(before, ofSensors.size()), Rename::rename);
    }

    /**
     * Returns what a sensor is called in a list of the ids of a robot, given an id that it has, had before or will have
     * there: a session may have the ids from before a renaming. Of an id that several sensors had, the last one counts.
     * The id itself if the list lacks the sensor.
     */
    String presentId(String id, List<String> ids) {
        return presentId(id, ids, ofSensors);
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

    /** Returns an earlier command of the timeline with the id that its sensor or obstacle has in the edited setup. */
    Command presentCommand(Command command, SimulationSetup edited) {
        Set<String> ids = ObstacleOrigins.idsIn(edited);
        return ObstacleOrigins.subject(command)
                .map(id ->
                        Rename.ofObstacle(id, presentId(id, ids, ofObstacles)).rename(command))
                .orElseGet(() -> withSensorIn(edited.robot().sensorIds(), command));
    }

    /** Returns a command with the id that its sensor has in a list of the ids of a robot. */
    private Command withSensorIn(List<String> ids, Command command) {
        return SensorReference.in(command)
                .map(id -> Rename.ofSensor(id, presentId(id, ids)).rename(command))
                .orElse(command);
    }

    /**
     * Returns a command of the edited scenario after a number of changes of ids of obstacles with the ids of the run,
     * given those of its sensors.
     */
    Command inRun(Command command, int renames, List<String> sensorIds) {
        return withSensorIn(sensorIds, renamed(command, between(renames, inRun), Rename::rename));
    }

    /** Returns a command of the run with the ids of the edited scenario, given those of its sensors. */
    Command ofRun(Command command, List<String> sensorIds) {
        return withSensorIn(sensorIds, renamed(command, since(inRun), Rename::rename));
    }

    /** Returns the result of a command of the run with the ids of the edited scenario, given those of its sensors. */
    CommandResult ofRun(CommandResult result, List<String> sensorIds) {
        CommandResult named = SensorReference.in(result.command())
                .map(id -> Rename.ofSensor(id, presentId(id, sensorIds)).rename(result))
                .orElse(result);
        return renamed(named, since(inRun), Rename::rename);
    }

    /** Returns a journal of the run with the ids that obstacles have in the journal that was made last. */
    Journal inJournal(Journal ofRun) {
        return renamed(ofRun, between(inRun, inJournal), Rename::rename);
    }

    /** Returns a command of the views with the id that its obstacle has in the edited scenario. */
    Command ofViews(Command command) {
        return renamed(command, since(inViews), Rename::rename);
    }

    /** Returns the id that an obstacle of the views has in the edited scenario. */
    String ofViews(String id) {
        return renamed(id, since(inViews), Rename::renameObstacle);
    }

    /**
     * Returns what gives the obstacles of the views the ids that they have in the run, which they have from now on;
     * empty if they have them already.
     */
    Optional<UnaryOperator<String>> takeForViews() {
        List<Rename> taken = between(inViews, inRun);
        inViews = inRun;
        return taken.isEmpty() ? Optional.empty() : Optional.of(id -> renamed(id, taken, Rename::renameObstacle));
    }

    private List<Rename> since(int count) {
        return between(count, ofObstacles.size());
    }

    /** Returns what leads from the ids of obstacles after a number of changes to those after another number. */
    private List<Rename> between(int from, int to) {
        return from <= to ? List.copyOf(ofObstacles.subList(from, to)) : Rename.inverse(ofObstacles.subList(to, from));
    }

    private static <T> T renamed(T value, List<Rename> changes, BiFunction<Rename, T, T> rename) {
        T renamed = value;
        for (Rename change : changes) {
            renamed = rename.apply(change, renamed);
        }
        return renamed;
    }
}
