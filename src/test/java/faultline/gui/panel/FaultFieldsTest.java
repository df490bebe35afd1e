package faultline.gui.panel;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import java.awt.GridBagLayout;
import java.util.Optional;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(EdtChecker.class)
class FaultFieldsTest {

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @Test
    void theSentenceAboutARefusedNumberWrapsAndDoesNotWidenTheForm() {
        runOnEdt(() -> {
            Messages.setLanguage(Language.POLISH);
            Theme.LIGHT.install();
            FaultFields<FaultKind, Fault> fields = FaultFields.forSensors();
            JPanel form = new JPanel(new GridBagLayout());
            fields.addTo(form, 0, 0);
            int width = form.getPreferredSize().width;
            ComponentFinder.find(form, JTextField.class, "Wartość").setText("1.2.3");
            assertEquals(Optional.empty(), fields.commitFault());
            JTextArea sentence =
                    ComponentFinder.findAll(form, JTextArea.class).findFirst().orElseThrow();
            assertTrue(sentence.getText().startsWith("Nieprawidłowa wartość. Dozwolone: "), sentence.getText());
            assertEquals(width, form.getPreferredSize().width);
            int line = sentence.getPreferredSize().height;
            sentence.setSize(width / 2, line);
            assertTrue(
                    sentence.getPreferredSize().height >= 2 * line,
                    sentence.getPreferredSize().toString());
        });
    }
}
