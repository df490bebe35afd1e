package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.theme.Theme;
import java.awt.event.KeyEvent;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.Test;

class UiActionTest {

    @Test
    void theMenuItemOfALongEditShowsTheStartOfItsName() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            UiAction undo = UiAction.of("undo", () -> {}).withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_Z));
            undo.rename("undo.of", "Move " + "desk-".repeat(40));
            JMenuItem item = new JMenuItem(undo);
            assertTrue(item.getText().matches("Undo Move (desk-)+\\S*\\.\\.\\."), item.getText());
            assertTrue(
                    item.getPreferredSize().width < 500, item.getPreferredSize().toString());
            undo.rename("undo.of", "Move desk");
            assertEquals("Undo Move desk", item.getText());
        });
    }
}
