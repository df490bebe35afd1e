package faultline.gui.panel;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SampleFrames;
import faultline.gui.EdtChecker;
import faultline.gui.edit.CommandSender;
import faultline.gui.theme.Theme;
import faultline.world.Command;
import faultline.world.Snapshot;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(EdtChecker.class)
class SensorsPanelTest {

    /** A field that is removed with its row loses the focus and commits its text, as here. */
    @Test
    void whatIsTypedForASensorThatTheNextRobotLacksChangesNothing() {
        Snapshot world = SampleFrames.fullFrame().snapshot();
        List<Command> commands = new ArrayList<>();
        runOnEdt(() -> {
            Theme.LIGHT.install();
            CommandSender sender = new CommandSender((sent, onExecuted) -> commands.addAll(sent));
            SensorsPanel panel = new SensorsPanel(sender);
            sender.pendingEdits().setRobot(world.robot());
            panel.setSensors(world.sensors());
            NumberSpinner range = NumberSpinner.findIn(panel).findFirst().orElseThrow();
            range.textField().setText("0.77");
            sender.pendingEdits().setRobot(world.robot().withSensors(List.of()));
            panel.setSensors(List.of());
            range.commitPendingEdit();
            assertEquals(List.of(), commands);
        });
    }
}
