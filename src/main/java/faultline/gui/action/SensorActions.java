package faultline.gui.action;

import faultline.control.ControllerSpec;
import faultline.control.WallSide;
import faultline.gui.canvas.tool.CanvasTools;
import faultline.gui.document.Workspace;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.SensorPresets;
import faultline.gui.edit.UndoController;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.awt.event.KeyEvent;

/** The actions that switch sensors, one by its key or several at once, and that add, copy and remove them. */
public final class SensorActions {

    private static final int SENSOR_KEYS = 8;
    private static final int ALL_SENSORS = Integer.MAX_VALUE;

    private final Workspace workspace;
    private final UndoController editor;
    private final SensorEditor sensorEditor;
    private final CanvasTools tools;

    public SensorActions(Workspace workspace, UndoController editor, SensorEditor sensorEditor, CanvasTools tools) {
        this.workspace = workspace;
        this.editor = editor;
        this.sensorEditor = sensorEditor;
        this.tools = tools;
    }

    public void addTo(ActionRegistry actions) {
        actions.add(UiAction.of("addSensor", this::add));
        actions.add(UiAction.of("sensorsTwo", () -> applyPreset(2)));
        actions.add(UiAction.of("sensorsThree", () -> applyPreset(3)));
        actions.add(UiAction.of("sensorsAll", () -> applyPreset(ALL_SENSORS)));
        for (int i = 0; i < SENSOR_KEYS; i++) {
            int index = i;
            actions.add(UiAction.of("sensor" + (i + 1), () -> toggle(index))
                    .withAccelerator(Keystrokes.unmodified(KeyEvent.VK_1 + i)));
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

    /** Removes a sensor. */
    public void remove(String id) {
        sensorEditor.remove(id);
    }

    private void applyPreset(int count) {
        editor.send(SensorPresets.commands(robot(), isWallOnLeft(), count));
    }

    private void toggle(int index) {
        robot().sensors().stream()
                .skip(index)
                .findFirst()
                .ifPresent(sensor -> editor.send(new Command.SwitchSensor(sensor.id(), !sensor.on())));
    }

    private RobotSpec robot() {
        return editor.pendingEdits().robot();
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
