package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.gui.edit.UndoController;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;

/** The list of active faults, with the sensors of a real world. */
class FaultListTest {

    private final List<List<Command>> sent = new ArrayList<>();
    private final World world =
            new World(new WorldSpec(6, 4, true, 0, List.of()), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);

    @Test
    void allFaultsAreClearedInOneEdit() {
        world.execute(new Command.InjectFault("left", new Fault.Dead()));
        world.execute(new Command.InjectFault("left", new Fault.Stuck(0.4)));
        world.execute(new Command.InjectFault("rear", new Fault.Dead()));
        FaultList list = callOnEdt(
                () -> new FaultList(new UndoController((commands, onExecuted) -> sent.add(commands), () -> {})));
        runOnEdt(() -> list.setSensors(world.snapshot().sensors()));
        runOnEdt(() -> ComponentFinder.findAll(list, JButton.class)
                .filter(button -> "Repair all".equals(button.getText()))
                .findFirst()
                .orElseThrow()
                .doClick(0));
        assertEquals(List.of(List.<Command>of(new Command.ClearFaults("left"), new Command.ClearFaults("rear"))), sent);
    }
}
