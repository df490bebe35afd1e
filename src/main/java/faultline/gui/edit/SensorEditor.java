package faultline.gui.edit;

import faultline.gui.change.Rename;
import faultline.gui.document.Workspace;
import faultline.gui.text.Messages;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ScenarioLimits;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Adds, copies, renames and removes sensors of the scenario's robot, with undo. The run is simulated again with the
 * changed robot. Event dispatch thread only.
 */
public final class SensorEditor {

    private final Workspace workspace;
    private final ScenarioEditor editor;
    private final Consumer<String> notes;

    /**
     * Creates an editor; {@code notes} receives sentences in the current language about what else has changed, or why
     * nothing has.
     */
    public SensorEditor(Workspace workspace, ScenarioEditor editor, Consumer<String> notes) {
        this.workspace = workspace;
        this.editor = editor;
        this.notes = notes;
    }

    /**
     * Adds a sensor that faces the widest gap between the other sensors. Returns its id; empty if the robot can have no
     * further sensor.
     */
    public Optional<String> add() {
        return extensibleRobot().map(robot -> append(robot, new NewSensors(robot).inWidestGap()));
    }

    /**
     * Adds a sensor that faces a direction, radians from straight ahead. Returns its id; empty if the robot can have no
     * further sensor.
     */
    public Optional<String> add(double direction) {
        return extensibleRobot().map(robot -> append(robot, new NewSensors(robot).facing(direction)));
    }

    /** Adds a copy of a sensor. Returns its id; empty if there is no such sensor or no further one is possible. */
    public Optional<String> duplicate(String id) {
        return extensibleRobot().flatMap(robot -> robot.sensor(id)
                .map(original -> append(robot, new NewSensors(robot).copyOf(original))));
    }

    /** Returns the robot; empty if it can have no further sensor, which is reported. */
    private Optional<RobotSpec> extensibleRobot() {
        Optional<RobotSpec> robot =
                workspace.scenario().map(scenario -> scenario.setup().robot());
        if (robot.filter(now -> now.sensors().size() >= ScenarioLimits.MAX_SENSORS)
                .isPresent()) {
            notes.accept(Messages.get("note.sensorLimit", Integer.toString(ScenarioLimits.MAX_SENSORS)));
            return Optional.empty();
        }
        return robot;
    }

    /** Adds a sensor after the others, so that their places and numbers remain. Returns its id. */
    private String append(RobotSpec robot, SensorSpec added) {
        PlacedSensor placed = new PlacedSensor(added, robot.sensors().size(), new TreeMap<>());
        editor.edit(() -> Messages.get("edit.add", added.id()), added, placed::addedTo, placed::removedFrom);
        return added.id();
    }

    /**
     * Gives a sensor another id, in the robot and in all commands about it. Returns why the id is refused, a sentence
     * in the current language; empty if it is not.
     */
    public Optional<String> rename(String id, String newId) {
        List<String> ids = workspace
                .scenario()
                .map(scenario -> scenario.setup().robot().sensorIds())
                .orElse(List.of());
        if (newId.equals(id) || !ids.contains(id)) {
            return Optional.empty();
        }
        if (!AttributeReader.isId(newId)) {
            return Optional.of(Messages.get("id.invalid"));
        }
        if (ids.contains(newId)) {
            return Optional.of(Messages.get("sensor.id.taken", newId));
        }
        editor.rename(Rename.ofSensor(id, newId));
        return Optional.empty();
    }

    /**
     * Removes a sensor and the commands of the timeline about it, whose number is reported, as soon as the run has
     * answered the edits that are being undone or redone: these are undone on the timeline afterwards. The sensor may
     * be renamed until then. {@code onRestored} is called with its id when the removal has been undone, before the run
     * has the sensor again.
     */
    public void remove(String id, Consumer<String> onRestored) {
        Supplier<String> present = workspace.followSensor(id);
        editor.editWhenAnswered(() -> workspace
                .scenario()
                .flatMap(scenario -> PlacedSensor.find(scenario, present.get()))
                .ifPresent(removed -> remove(removed, onRestored)));
    }

    private void remove(PlacedSensor removed, Consumer<String> onRestored) {
        String id = removed.sensor().id();
        // The undo of the deletion returns the sensor's events to the timeline, where they are undone then.
        editor.putEventsOnTimeline();
        editor.edit(
                () -> Messages.get("edit.remove", id),
                removed,
                removed::removedFrom,
                removed::addedTo,
                () -> onRestored.accept(id));
        int commands = removed.commands().size();
        if (commands > 0) {
            notes.accept(Messages.get("note.sensorCommands", id, Integer.toString(commands)));
        }
    }
}
