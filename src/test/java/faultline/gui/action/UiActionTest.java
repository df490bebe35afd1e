package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class UiActionTest {

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    /** Swing underlines the first letter that is equal to the mnemonic. */
    @ParameterizedTest
    @EnumSource(Language.class)
    void theMarkedLetterIsUnderlined(Language language) {
        runOnEdt(() -> {
            UiAction action = UiAction.of("zoomIn", () -> {});
            JMenuItem item = new JMenuItem(action);
            JMenuItem other = new JMenuItem();
            Messages.setLanguage(language);
            for (String key : List.of("saveAs", "snapAngle", "zoomOut", "controlPanel", "selectNext", "timeline")) {
                String marked = Messages.get("action." + key);
                action.rename(key);
                assertEquals(marked.indexOf('&'), item.getDisplayedMnemonicIndex(), marked);
                UiText.menuText(other, "action." + key);
                assertEquals(marked.indexOf('&'), other.getDisplayedMnemonicIndex(), marked);
                assertEquals(item.getText(), other.getText());
            }
        });
    }

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
