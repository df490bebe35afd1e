package faultline.gui.panel;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.text.FaultText;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import java.awt.GridBagLayout;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
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

    @Test
    void theFieldWithTheRefusedNumberIsDescribedByTheReason() {
        runOnEdt(() -> {
            FaultFields<FaultKind, Fault> fields = FaultFields.forSensors();
            JPanel form = new JPanel(new GridBagLayout());
            fields.addTo(form, 0, 0);
            fields.setFault(FaultKind.BURSTS, 0.5, 2);
            JTextField value = ComponentFinder.find(form, JTextField.class, "Value");
            JTextField length = ComponentFinder.find(form, JTextField.class, "Mean length");
            length.setText("-1");
            assertEquals(Optional.empty(), fields.commitFault());
            assertTrue(description(length).startsWith("Invalid value."), description(length));
            assertFalse(description(value).startsWith("Invalid value."), description(value));
            length.setText("3");
            value.setText("x");
            assertEquals(Optional.empty(), fields.commitFault());
            assertTrue(description(value).startsWith("Invalid value."), description(value));
            assertFalse(description(length).startsWith("Invalid value."), description(length));
        });
    }

    @Test
    void theChosenKindIsExplainedBesideTheListAndInTheForm() {
        runOnEdt(() -> {
            FaultFields<FaultKind, Fault> fields = FaultFields.forSensors();
            JPanel form = new JPanel(new GridBagLayout());
            fields.addWithDescription(form, 0);
            fields.setFault(FaultKind.MISALIGNED, 15, 0);
            JComboBox<?> kind = ComponentFinder.find(form, JComboBox.class, "Fault");
            String sentence = "The sensor measures in a direction that differs from its bearing";
            assertEquals(sentence, kind.getToolTipText());
            assertEquals(sentence, kind.getAccessibleContext().getAccessibleDescription());
            assertEquals(1, countTexts(form, sentence));
            JTextField value = ComponentFinder.find(form, JTextField.class, "Value");
            assertEquals("Angle from the bearing, °, positive to the left (-180 to 180)", value.getToolTipText());
            assertEquals(value.getToolTipText(), description(value));
            fields.setFault(FaultKind.OFF, 0, 0);
            assertEquals("The sensor gives no answer", kind.getToolTipText());
            assertEquals("A fault of this kind has no value", value.getToolTipText());
        });
    }

    private static long countTexts(JPanel form, String text) {
        return ComponentFinder.findAll(form, JTextArea.class)
                .filter(area -> area.getText().equals(text))
                .count();
    }

    @Test
    @SuppressWarnings("unchecked")
    void theItemsOfTheListOfKindsAreExplained() {
        runOnEdt(() -> {
            JPanel form = new JPanel(new GridBagLayout());
            FaultFields.forSensors().addTo(form, 0, 0);
            JComboBox<FaultKind> kind = ComponentFinder.find(form, JComboBox.class, "Fault");
            JComponent item = (JComponent) kind.getRenderer()
                    .getListCellRendererComponent(new JList<>(), FaultKind.CROSS_TALK, 0, false, false);
            assertEquals(FaultText.describe(FaultKind.CROSS_TALK), item.getToolTipText());
            assertEquals(item.getToolTipText(), item.getAccessibleContext().getAccessibleDescription());
        });
    }

    private static String description(JTextField field) {
        return field.getAccessibleContext().getAccessibleDescription();
    }
}
