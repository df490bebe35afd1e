package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.gui.edit.CommandSender;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.awt.Component;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

/** The list of active faults, with the sensors and motors of a real world. */
class FaultListTest {

    private static final MotorFault WEAK = new MotorFault.Weak(0.5);

    private final List<List<Command>> sent = new ArrayList<>();
    private final World world =
            new World(new WorldSpec(6, 4, true, 0, List.of()), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);

    @Test
    void allFaultsAreClearedInOneEdit() {
        world.execute(new Command.InjectFault("left", new Fault.Dead()));
        world.execute(new Command.InjectFault("left", new Fault.Stuck(0.4)));
        world.execute(new Command.InjectFault("rear", new Fault.Dead()));
        FaultList list = createList();
        runOnEdt(() -> list.setSensors(world.snapshot().sensors(), List.of(), 0));
        repairAll(list);
        assertEquals(List.of(List.<Command>of(new Command.ClearFaults("left"), new Command.ClearFaults("rear"))), sent);
    }

    private FaultList createList() {
        return callOnEdt(() -> new FaultList(new CommandSender((commands, onExecuted) -> sent.add(commands))));
    }

    private static void repairAll(FaultList list) {
        runOnEdt(() -> ComponentFinder.findAll(list, JButton.class)
                .filter(button -> "Repair all".equals(button.getText()))
                .findFirst()
                .orElseThrow()
                .doClick(0));
    }

    private static List<String> texts(FaultList list) {
        return callOnEdt(() ->
                ComponentFinder.findAll(list, JLabel.class).map(JLabel::getText).toList());
    }

    @Test
    void aFaultOfMotorsIsRepairedAloneAndAllAreInOneEdit() {
        world.execute(new Command.InjectMotorFault(MotorSide.RIGHT, new MotorFault.NoDrive()));
        world.execute(new Command.InjectMotorFault(MotorSide.LEFT, WEAK));
        FaultList list = createList();
        runOnEdt(() -> list.setMotors(world.snapshot().motorFaults(), List.of(), 0));
        assertEquals(List.of("left motors:", "weak 0.50", "right motors:", "dead"), texts(list));
        runOnEdt(() -> ComponentFinder.find(list, JButton.class, "Repair left motors: weak 0.50")
                .doClick(0));
        repairAll(list);
        assertEquals(
                List.of(
                        List.<Command>of(new Command.ClearMotorFault(MotorSide.LEFT, WEAK)),
                        List.<Command>of(
                                new Command.ClearMotorFaults(MotorSide.LEFT),
                                new Command.ClearMotorFaults(MotorSide.RIGHT))),
                sent);
    }

    @Test
    void theRemainingTimePassesWithoutMovingAnything() {
        world.execute(new Command.InjectFault("left", new Fault.Stuck(0.4)));
        world.execute(new Command.InjectFault("rear", new Fault.Dead()));
        List<TimedCommand> timeline =
                List.of(new TimedCommand(12, new Command.ClearFault("left", new Fault.Stuck(0.4))));
        FaultList list = createList();
        runOnEdt(() -> list.setSensors(world.snapshot().sensors(), timeline, 2));
        assertEquals(List.of("left:", "stuck 0.40 m", "10.0 s left", "rear:", "off, no reading"), texts(list));
        List<Component> before = callOnEdt(() -> List.of(list.getComponents()));
        Dimension size = callOnEdt(list::getPreferredSize);
        runOnEdt(() -> list.setSensors(world.snapshot().sensors(), timeline, 11.96));
        assertEquals("0.0 s left", texts(list).get(2));
        assertEquals(before, callOnEdt(() -> List.of(list.getComponents())), "the same rows");
        assertEquals(size, callOnEdt(list::getPreferredSize));
        JLabel remaining = ComponentFinder.findValue(list, "left: stuck 0.40 m ends at 12 s");
        assertEquals("Ends at 12 s, by the time line", callOnEdt(remaining::getToolTipText));
    }

    /** The fault of an interval may be equal to that of another one to which the run is moved. */
    @Test
    void theRemainingTimeIsThatOfThePresentInterval() {
        world.execute(new Command.InjectMotorFault(MotorSide.LEFT, WEAK));
        Command repair = new Command.ClearMotorFault(MotorSide.LEFT, WEAK);
        List<TimedCommand> timeline = List.of(
                new TimedCommand(20, repair),
                new TimedCommand(30, new Command.InjectMotorFault(MotorSide.LEFT, WEAK)),
                new TimedCommand(40, repair));
        FaultList list = createList();
        for (double now : new double[] {15, 35, 15, 10, 35}) {
            runOnEdt(() -> list.setMotors(world.snapshot().motorFaults(), timeline, now));
            assertEquals(now == 10 ? "10.0 s left" : "5.0 s left", texts(list).get(2), "at " + now);
        }
        runOnEdt(() -> list.setMotors(world.snapshot().motorFaults(), List.of(), 10));
        assertEquals(List.of("left motors:", "weak 0.50"), texts(list));
    }
}
