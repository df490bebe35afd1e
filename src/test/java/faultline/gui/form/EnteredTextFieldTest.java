package faultline.gui.form;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.theme.Theme;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** A text that is applied when the focus leaves its field. */
class EnteredTextFieldTest {

    @Test
    void aTextStaysAsItIsTypedWhileAnotherWindowHasTheFocus() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            List<String> applied = new ArrayList<>();
            EnteredTextField.IdField field = new EnteredTextField.IdField("faults.id", 8, (id, text) -> {
                applied.add(text);
                return text.equals("taken") ? Optional.of("It is taken.") : Optional.empty();
            });
            field.setId("left");
            for (String text : List.of("le", "taken")) {
                field.setText(text);
                loseFocus(field, true);
                assertEquals(text, field.getText());
            }
            assertEquals(List.of(), applied);
            loseFocus(field, false);
            assertEquals(List.of("taken"), applied);
            assertEquals("left", field.getText());
        });
    }

    private static void loseFocus(EnteredTextField field, boolean temporarily) {
        for (FocusListener listener : field.getFocusListeners()) {
            listener.focusLost(new FocusEvent(field, FocusEvent.FOCUS_LOST, temporarily));
        }
    }
}
