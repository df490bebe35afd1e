package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.EdtChecker;
import faultline.gui.text.Messages;
import faultline.robot.MotorFaultKind;
import faultline.sensor.FaultKind;
import java.awt.GridBagLayout;
import java.util.Arrays;
import java.util.List;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(EdtChecker.class)
class FaultFieldsTest {

    @Test
    void aShareOfASensorIsOneOfTicksAndThatOfMotorsOneOfTheVoltage() {
        assertEquals(List.of(Messages.get("faults.share"), "s"), callOnEdt(() -> {
            FaultFields<FaultKind, ?> fields = FaultFields.forSensors();
            fields.setFault(FaultKind.DROPOUT, 0.5, 1);
            return units(fields);
        }));
        assertEquals(List.of(Messages.get("motorFault.share"), "s"), callOnEdt(() -> {
            FaultFields<MotorFaultKind, ?> fields = FaultFields.forMotors();
            fields.setFault(MotorFaultKind.WEAK, 0.5, 1);
            return units(fields);
        }));
    }

    /** Returns the units of the number and of the length. */
    private static List<String> units(FaultFields<?, ?> fields) {
        JPanel form = new JPanel(new GridBagLayout());
        fields.addTo(form, 0, 0);
        return Arrays.stream(form.getComponents())
                .filter(part -> part instanceof MutedLabel)
                .map(part -> ((MutedLabel) part).getText())
                .toList();
    }
}
