package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.theme.Theme;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class SensorActionsTest {

    private final ActionRegistry actions = new ActionRegistry();
    private final List<Command> sent = new ArrayList<>();
    private CommandSender sender;
    private SensorActions sensors;

    @Test
    void theSwitchesAreNamedAfterTheSensorsAndDisabledWithoutOne() {
        runOnEdt(() -> {
            addActions();
            SensorSpec nose = RobotSpec.DEFAULT.sensors().get(0).withId("nose");
            SensorSpec tail = RobotSpec.DEFAULT.sensors().get(4).withId("tail").withOn(false);
            sender.pendingEdits().setRobot(RobotSpec.DEFAULT.withSensors(List.of(nose, tail)));
            sensors.update();
            assertEquals(List.of("Sensor 1: nose", "Sensor 2: tail"), enabled());
            assertEquals(List.of("Sensor 1: nose"), on());
            sender.pendingEdits().setRobot(RobotSpec.DEFAULT);
            sensors.update();
            assertEquals(8, enabled().size());
            assertEquals("Sensor 8: front-right", enabled().get(7));
            assertEquals(enabled(), on());
        });
    }

    /** The first item stays in the menu without a sensor. */
    @Test
    void aSwitchWithoutASensorNamesNone() {
        runOnEdt(() -> {
            addActions();
            sender.pendingEdits().setRobot(RobotSpec.DEFAULT);
            sensors.update();
            assertEquals("Sensor 1: front", actions.get("sensor1").name());
            sender.pendingEdits().setRobot(RobotSpec.DEFAULT.withSensors(List.of()));
            sensors.update();
            assertEquals("Sensor 1", actions.get("sensor1").name());
        });
    }

    @Test
    void aSwitchTurnsItsSensorOffAtOnce() {
        runOnEdt(() -> {
            addActions();
            sensors.update();
            actions.get("sensor3").actionPerformed(null);
            assertEquals(List.of(new Command.SwitchSensor("left", false)), sent);
            assertEquals(7, on().size());
        });
    }

    private List<String> enabled() {
        return switches().filter(UiAction::isEnabled).map(UiAction::name).toList();
    }

    private List<String> on() {
        return switches().filter(UiAction::isOn).map(UiAction::name).toList();
    }

    private Stream<UiAction> switches() {
        return IntStream.rangeClosed(1, 8).mapToObj(number -> actions.get("sensor" + number));
    }

    private void addActions() {
        Theme.LIGHT.install();
        Workspace workspace = new Workspace();
        sender = new CommandSender((commands, onExecuted) -> sent.addAll(commands));
        SimulationCanvas canvas = new SimulationCanvas(sender);
        UndoController undo = new UndoController(sender, () -> {});
        ScenarioEditor scenarios = new ScenarioEditor(new RunController(workspace), undo);
        sensors = new SensorActions(
                workspace, sender, new SensorEditor(workspace, scenarios, note -> {}), canvas.tools());
        sensors.addTo(actions);
    }
}
