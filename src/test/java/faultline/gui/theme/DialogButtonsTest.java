package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class DialogButtonsTest {

    @AfterEach
    void closeMenu() {
        runOnEdt(() -> MenuSelectionManager.defaultManager().clearSelectedPath());
    }

    @Test
    void escapeClosesAMenuBeforeTheDialog() {
        List<String> closed = new ArrayList<>();
        runOnEdt(() -> {
            MenuSelectionManager.defaultManager().setSelectedPath(new MenuElement[] {new JPopupMenu()});
            DialogButtons.closeMenuOrRun(() -> closed.add("the dialog"));
        });
        assertEquals(List.of(), closed);
        assertEquals(0, callOnEdt(() -> MenuSelectionManager.defaultManager().getSelectedPath().length));
        runOnEdt(() -> DialogButtons.closeMenuOrRun(() -> closed.add("the dialog")));
        assertEquals(List.of("the dialog"), closed);
    }
}
