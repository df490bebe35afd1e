package faultline.gui.motor;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.gui.edit.CommandSender;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.awt.Point;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The section of the control panel for faults of motors, with those of a real world. */
class MotorPanelTest {

    private static final MotorFault WEAK = new MotorFault.Weak(0.5);

    private final List<Command> sent = new ArrayList<>();
    private final List<MotorSide> asked = new ArrayList<>();
    private final World world =
            new World(new WorldSpec(6, 4, true, 0, List.of()), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);
    private MotorPanel panel;

    @BeforeEach
    void create() {
        panel = callOnEdt(() -> {
            Theme.LIGHT.install();
            CommandSender sender = new CommandSender((commands, onExecuted) -> sent.addAll(commands));
            return new MotorPanel(sender, asked::add);
        });
    }

    private void show(List<TimedCommand> timeline) {
        runOnEdt(() -> {
            panel.setSnapshot(world.snapshot(), timeline);
            panel.setSize(400, panel.getPreferredSize().height);
            // The second pass lays out with the heights of the first.
            ComponentFinder.layOut(panel);
            ComponentFinder.layOut(panel);
        });
    }

    private JButton button(String name) {
        return ComponentFinder.find(panel, JButton.class, name);
    }

    private Stream<Boolean> enabled() {
        return callOnEdt(() -> ComponentFinder.findAll(panel, JButton.class)
                        .map(JButton::isEnabled)
                        .toList())
                .stream();
    }

    private List<String> labels() {
        return callOnEdt(() -> ComponentFinder.findAll(panel, JLabel.class)
                .map(JLabel::getText)
                .toList());
    }

    @Test
    void theButtonsAskForAFaultOfTheirSideAsSoonAsThereIsARun() {
        assertEquals(List.of(false, false), enabled().toList());
        show(List.of());
        runOnEdt(() -> {
            button("Add a fault of the right motors").doClick(0);
            button("Add a fault of the left motors").doClick(0);
        });
        assertEquals(List.of(MotorSide.RIGHT, MotorSide.LEFT), asked);
        assertEquals(List.of("Add fault", "No active faults"), labels());
    }

    @Test
    void theFaultsOfBothSidesAreListedWithTheirRemainingTimeAndRepaired() {
        world.execute(new Command.InjectMotorFault(MotorSide.RIGHT, new MotorFault.DeadBand(0.5)));
        world.execute(new Command.InjectMotorFault(MotorSide.LEFT, WEAK));
        show(List.of(new TimedCommand(8, new Command.ClearMotorFault(MotorSide.LEFT, WEAK))));
        assertEquals(
                List.of("Add fault", "left motors:", "weak 0.50", "8.0 s left", "right motors:", "dead band 0.50 V"),
                labels());
        runOnEdt(() -> button("Repair right motors: dead band 0.50 V").doClick(0));
        assertEquals(
                List.<Command>of(new Command.ClearMotorFault(MotorSide.RIGHT, new MotorFault.DeadBand(0.5))), sent);
    }

    @Test
    void faultsThatComeAndGoMoveNoButtonThatAddsOne() {
        show(List.of());
        List<Point> before = buttonLocations();
        for (int i = 0; i < 3; i++) {
            world.execute(new Command.InjectMotorFault(MotorSide.LEFT, WEAK));
            show(List.of(new TimedCommand(8, new Command.ClearMotorFaults(MotorSide.LEFT))));
            assertEquals(before, buttonLocations());
        }
    }

    private List<Point> buttonLocations() {
        return callOnEdt(() -> Stream.of(MotorSide.values())
                .map(side -> button("Add a fault of the " + side.fileName() + " motors"))
                .map(each -> SwingUtilities.convertPoint(each, 0, 0, panel))
                .toList());
    }

    @Test
    void theTextsFollowTheLanguage() {
        world.execute(new Command.InjectMotorFault(MotorSide.LEFT, WEAK));
        try {
            runOnEdt(() -> {
                Messages.setLanguage(Language.POLISH);
                panel = new MotorPanel(new CommandSender((commands, onExecuted) -> {}), asked::add);
            });
            show(List.of(new TimedCommand(8, new Command.ClearMotorFaults(MotorSide.LEFT))));
            assertEquals(List.of("Dodaj uszkodzenie", "lewe silniki:", "słabe 0.50", "jeszcze 8.0 s"), labels());
        } finally {
            runOnEdt(() -> Messages.setLanguage(Language.ENGLISH));
        }
    }
}
