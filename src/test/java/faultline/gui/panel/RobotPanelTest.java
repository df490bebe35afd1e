package faultline.gui.panel;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.EdtChecker;
import faultline.gui.action.UiAction;
import faultline.gui.edit.CommandSender;
import faultline.gui.form.NumberSpinner;
import faultline.gui.theme.Theme;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@ExtendWith(EdtChecker.class)
class RobotPanelTest {

    /** 0.12345 m/s per volt and 1.01 V are 0.1246845 m/s. */
    @ParameterizedTest
    @CsvSource({
        "0.12345, 1.01, 0.01 to 0.1246, 0.1246",
        "0.5, 2, 0.01 to 1, 1",
        "0.57, 1, 0.01 to 0.57, 0.57",
        "0.001, 1, 0.001 to 0.001, 0.001"
    })
    void theGreatestVelocityThatTheFieldNamesIsAllowed(double constant, double volts, String limits, String greatest) {
        List<Command> commands = new ArrayList<>();
        RobotSpec robot = RobotSpec.DEFAULT.withMotor(new MotorSpec(0.05, constant, volts));
        runOnEdt(() -> {
            Theme.LIGHT.install();
            CommandSender sender = new CommandSender((sent, onExecuted) -> commands.addAll(sent));
            RobotPanel panel = new RobotPanel(sender, UiAction.of("path", () -> {}));
            sender.pendingEdits().setRobot(robot);
            panel.setRobot(robot);
            NumberSpinner speed = NumberSpinner.findIn(panel).findFirst().orElseThrow();
            assertEquals(limits, speed.limitsText());
            speed.textField().setText(greatest);
            assertTrue(speed.commitValidEdit());
        });
        assertEquals(
                List.of(new Command.SetPlatform(robot.length(), robot.width(), Double.parseDouble(greatest))),
                commands);
    }
}
