package faultline.gui.panel;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Vec;
import faultline.gui.Components;
import faultline.gui.action.UiAction;
import faultline.gui.text.Texts;
import faultline.gui.theme.Theme;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Snapshot;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The control panel without a display, shown the snapshot that has some of everything. */
class ControlPanelTest {

    private final List<Command> commands = new ArrayList<>();
    private final Snapshot world = SampleFrames.everything().world();
    private ControlPanel panel;

    @BeforeEach
    void show() {
        panel = onEdt(() -> {
            Theme.LIGHT.install();
            ControlPanel made = new ControlPanel(commands::add, UiAction.toggle("path", true, on -> {
            }));
            made.show(world);
            return made;
        });
    }

    @Test
    void everySensorHasASwitchThatStandsAsItDoes() {
        for (int i = 0; i < world.sensors().size(); i++) {
            String id = world.sensors().get(i).spec().id();
            assertEquals(world.sensors().get(i).spec().on(), onEdt(() -> switchOf(id).isSelected()), id);
        }
    }

    @Test
    void aClickOnASwitchIsACommandAndShowsAtOnce() {
        edt(() -> switchOf("front").doClick(0));
        edt(() -> panel.show(world));
        assertEquals(List.of(new Command.SwitchSensor("front", false)), commands);
        assertFalse(onEdt(() -> switchOf("front").isSelected()));
    }

    @Test
    void aSwitchThatTheWorldRefusesGoesBack() {
        edt(() -> switchOf("front").doClick(0));
        edt(() -> {
            for (int i = 0; i <= Echo.PATIENCE; i++) {
                panel.show(world);
            }
        });
        assertTrue(onEdt(() -> switchOf("front").isSelected()));
    }

    @Test
    void rangeAndConeSetOneAfterTheOtherBothArrive() {
        edt(() -> {
            spinner("Range of left, metres").setValue(1.5);
            spinner("Cone of left, degrees").setValue(90.0);
        });
        Command.TuneSensor last = (Command.TuneSensor) commands.get(1);
        assertEquals(1.5, last.sensor().range());
        assertEquals(Math.PI / 2, last.sensor().cone(), 1e-15);
        assertEquals(world.sensors().get(2).spec().seat(), last.sensor().seat());
    }

    @Test
    void thePlatformIsSetAsAWhole() {
        edt(() -> {
            spinner("Linear velocity").setValue(0.5);
            spinner("Platform length").setValue(0.3);
        });
        assertEquals(new Command.SetPlatform(0.3, RobotSpec.DEFAULT.width(), 0.5), commands.get(1));
    }

    @Test
    void readingsAreNumbersDashesOrOff() {
        assertEquals(List.of("0.240", "–", "0.400", "–", "off", "off", "–", "–"), readings(ReadingBar.Side.REPORTED));
    }

    @Test
    void whatIsReallyThereStandsBesideWhatIsReported() {
        List<String> expected = world.sensors().stream().map(sensor -> ReadingText.of(sensor.truth())).toList();
        assertEquals(expected, readings(ReadingBar.Side.TRUE));
        assertNotEquals(expected, readings(ReadingBar.Side.REPORTED));
    }

    private List<String> readings(ReadingBar.Side side) {
        return onEdt(() -> Components.all(panel, ReadingBar.class).filter(bar -> bar.side() == side).map(ReadingBar::text).toList());
    }

    @Test
    void theMountOfTheChosenSensorCanBeSet() {
        edt(() -> {
            panel.select(Optional.of("left"));
            spinner(Texts.text("mount.bearing.tip")).setValue(80.0);
            spinner(Texts.text("mount.noise.tip")).setValue(0.004);
            spinner(Texts.text("mount.ahead.tip")).setValue(0.05);
            spinner(Texts.text("mount.aside.tip")).setValue(0.08);
        });
        SensorSpec left = world.sensors().get(2).spec();
        assertEquals(new Command.TuneSensor(left.withBearing(Math.toRadians(80)).withNoise(0.004).withSeat(new Vec(0.05, 0.08))),
                commands.get(3));
    }

    @Test
    void whatTwoControlsSetOfOneSensorBothArrives() {
        edt(() -> {
            panel.select(Optional.of("left"));
            spinner("Range of left, metres").setValue(1.5);
            spinner(Texts.text("mount.noise.tip")).setValue(0.004);
        });
        assertEquals(new Command.TuneSensor(world.sensors().get(2).spec().withRange(1.5).withNoise(0.004)), commands.get(1));
    }

    @Test
    void theFieldsShowTheChosenSensor() {
        edt(() -> panel.select(Optional.of("front-left")));
        assertEquals("front-left", onEdt(() -> Components.named(panel, JComboBox.class, "Sensor").getSelectedItem()));
        assertEquals(45, onEdt(() -> spinner(Texts.text("mount.bearing.tip")).value()), 1e-12);
    }

    @Test
    void aSensorChosenByNameIsMarkedToo() {
        List<Optional<String>> told = new ArrayList<>();
        edt(() -> {
            panel.addSelectionListener(told::add);
            Components.named(panel, JComboBox.class, "Sensor").setSelectedItem("rear");
        });
        assertEquals(List.of(Optional.of("rear")), told);
    }

    @Test
    void whatIsBeingTypedGoesToTheSensorThatItWasTypedFor() {
        edt(() -> {
            panel.select(Optional.of("left"));
            spinner(Texts.text("mount.bearing.tip")).text().setText("75");
            panel.select(Optional.of("front"));
        });
        assertEquals(List.of(new Command.TuneSensor(world.sensors().get(2).spec().withBearing(Math.toRadians(75)))), commands);
    }

    @Test
    void aFaultyReadingSaysSoInWords() {
        assertEquals("Reading of left: 0.400 (faulty: stuck 0.40 m)",
                onEdt(() -> Components.named(panel, ReadingBar.class, "Reading of left").getToolTipText()));
    }

    @Test
    void activeFaultsAreListedAndEachCanBeMended() {
        assertTrue(onEdt(() -> Components.all(panel, JLabel.class).anyMatch(label -> label.getText().equals("left: stuck 0.40 m"))));
        edt(() -> Components.named(panel, JButton.class, "Mend left: stuck 0.40 m").doClick(0));
        assertEquals(List.of(new Command.ClearFault("left", new Fault.Stuck(0.4))), commands);
    }

    @Test
    void everyKindOfFaultCanBeInjectedWithItsUsualNumber() {
        edt(() -> Components.named(panel, JComboBox.class, "Sensor").setSelectedItem("rear"));
        for (FaultKind kind : FaultKind.values()) {
            edt(() -> {
                Components.named(panel, JComboBox.class, "Fault").setSelectedItem(kind);
                Components.named(panel, JButton.class, "Inject").doClick(0);
            });
        }
        List<Command> expected = new ArrayList<>();
        for (FaultKind kind : FaultKind.values()) {
            expected.add(new Command.InjectFault("rear", kind.fault(kind.usual())));
        }
        assertEquals(expected, commands);
    }

    private JCheckBox switchOf(String id) {
        return Components.named(panel, JCheckBox.class, "Switch " + id);
    }

    private NumberSpinner spinner(String name) {
        return Components.named(panel, NumberSpinner.class, name);
    }
}
