package faultline.gui.action;

import faultline.control.ControllerSpec;
import faultline.control.WallSide;
import faultline.gui.canvas.tool.CanvasTools;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.SensorPresets;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** The actions that switch sensors, one by its key or several at once, and that add, copy, rename and remove them. */
public final class SensorActions {

    private static final int SENSOR_KEYS = 8;
    private static final int ALL_SENSORS = Integer.MAX_VALUE;

    private final Workspace workspace;
    private final CommandSender sender;
    private final SensorEditor sensorEditor;
    private final CanvasTools tools;
    private final List<UiAction> switches;
    /** The sensors that the names of the switches show. */
    private List<String> namedIds = List.of();

    public SensorActions(Workspace workspace, CommandSender sender, SensorEditor sensorEditor, CanvasTools tools) {
        this.workspace = workspace;
        this.sender = sender;
        this.sensorEditor = sensorEditor;
        this.tools = tools;
        switches = IntStream.range(0, SENSOR_KEYS).mapToObj(this::createSwitch).toList();
    }

    private UiAction createSwitch(int index) {
        return UiAction.toggle("sensor" + (index + 1), false, on -> toggle(index))
                .withAccelerator(Keystrokes.unmodified(KeyEvent.VK_1 + index));
    }

    public void addTo(ActionRegistry actions) {
        actions.add(UiAction.of("addSensor", this::add));
        actions.add(UiAction.of("sensorsTwo", () -> applyPreset(2)));
        actions.add(UiAction.of("sensorsThree", () -> applyPreset(3)));
        actions.add(UiAction.of("sensorsAll", () -> applyPreset(ALL_SENSORS)));
        switches.forEach(actions::add);
    }

    /** Names the switches after the robot's sensors, shows which are on, and disables those without a sensor. */
    public void update() {
        List<SensorSpec> sensors = robot().sensors();
        List<String> ids =
                sensors.stream().map(SensorSpec::id).limit(SENSOR_KEYS).toList();
        for (int i = 0; i < SENSOR_KEYS; i++) {
            UiAction action = switches.get(i);
            boolean present = i < ids.size();
            action.setEnabled(present);
            action.setOn(present && sensors.get(i).on());
            if (!ids.equals(namedIds)) {
                rename(action, present ? ids.get(i) : null);
            }
        }
        namedIds = ids;
    }

    /** Names a switch after its sensor, or with its number if there is none. */
    private static void rename(UiAction action, String sensorOrNull) {
        if (sensorOrNull == null) {
            action.rename(action.key());
        } else {
            action.rename(action.key() + ".of", sensorOrNull);
        }
    }

    /** Adds a sensor that faces the widest gap between the others, and selects it. */
    public void add() {
        sensorEditor.add().ifPresent(tools::selectSensorWhenPresent);
    }

    /** Adds a sensor that faces a direction, radians from straight ahead, and selects it. */
    public void add(double direction) {
        sensorEditor.add(direction).ifPresent(tools::selectSensorWhenPresent);
    }

    /** Adds a copy of a sensor, and selects it. */
    public void duplicate(String id) {
        sensorEditor.duplicate(id).ifPresent(tools::selectSensorWhenPresent);
    }

    /** Removes a sensor; an undo of this selects it. */
    public void remove(String id) {
        sensorEditor.remove(id, tools::selectSensorWhenPresent);
    }

    /** Gives a sensor another id; returns why it is refused, empty if it is not. */
    public Optional<String> rename(String id, String newId) {
        return sensorEditor.rename(id, newId);
    }

    private void applyPreset(int count) {
        sender.send(SensorPresets.commands(robot(), isWallOnLeft(), count));
    }

    private void toggle(int index) {
        robot().sensors().stream()
                .skip(index)
                .findFirst()
                .ifPresent(sensor -> sender.send(new Command.SwitchSensor(sensor.id(), !sensor.on())));
        update();
    }

    private RobotSpec robot() {
        return sender.pendingEdits().robot();
    }

    private boolean isWallOnLeft() {
        return workspace
                .scenario()
                .map(scenario -> scenario.setup().controller())
                .filter(controller ->
                        controller instanceof ControllerSpec.WallFollowing follow && follow.side() == WallSide.RIGHT)
                .isEmpty();
    }
}
