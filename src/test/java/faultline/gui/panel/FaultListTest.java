package faultline.gui.panel;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Pose;
import faultline.gui.Components;
import faultline.gui.edit.Editor;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;

/** The list of active faults, with sensors of a real world. */
class FaultListTest {

    private final List<List<Command>> sent = new ArrayList<>();
    private final World world = new World(new WorldSpec(6, 4, true, 0, List.of()), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);

    /** Keeps what is sent together apart from what is not. */
    private final class Recorder implements Editor {
        @Override
        public void send(Command command) {
            sent.add(List.of(command));
        }

        @Override
        public void send(List<Command> commands) {
            sent.add(commands);
        }
    }

    @Test
    void allFaultsAreMendedInOneEdit() {
        world.apply(new Command.InjectFault("left", new Fault.Dead()));
        world.apply(new Command.InjectFault("left", new Fault.Stuck(0.4)));
        world.apply(new Command.InjectFault("rear", new Fault.Dead()));
        FaultList list = onEdt(() -> new FaultList(new Recorder()));
        edt(() -> list.show(world.snapshot().sensors()));
        edt(() -> Components.all(list, JButton.class).filter(button -> "Mend all".equals(button.getText())).findFirst().orElseThrow().doClick(0));
        assertEquals(List.of(List.<Command>of(new Command.ClearFaults("left"), new Command.ClearFaults("rear"))), sent);
    }
}
