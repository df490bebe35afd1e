package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.gui.action.Keystrokes;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GuardedMenuBarTest {

    private boolean chosen;

    /** The desktop types a comma for Ctrl+comma, too. */
    @ParameterizedTest
    @CsvSource({"0, true", "128, false", "256, false", "8704, true"})
    void aCharacterWithTheMenuKeyIsNotTheCharacterAlone(int modifiers, boolean acts) {
        boolean acted = callOnEdt(() -> {
            typeComma(createBar(), modifiers);
            return chosen;
        });
        assertEquals(acts, acted, () -> InputEvent.getModifiersExText(modifiers));
    }

    @Test
    void aKeyThatChoosesNothingInAnOpenMenuDoesNotActElsewhere() {
        assertFalse(callOnEdt(() -> {
            GuardedMenuBar bar = createBar();
            MenuSelectionManager.defaultManager().setSelectedPath(new MenuElement[] {bar});
            typeComma(bar, 0);
            MenuSelectionManager.defaultManager().clearSelectedPath();
            return chosen;
        }));
    }

    private GuardedMenuBar createBar() {
        JMenuItem item = new JMenuItem("Step back");
        item.setAccelerator(Keystrokes.character(','));
        item.addActionListener(event -> chosen = true);
        JMenu menu = new JMenu("Run");
        menu.add(item);
        GuardedMenuBar bar = new GuardedMenuBar();
        bar.add(menu);
        return bar;
    }

    private static void typeComma(GuardedMenuBar bar, int modifiers) {
        KeyEvent event = new KeyEvent(bar, KeyEvent.KEY_TYPED, 0, modifiers, KeyEvent.VK_UNDEFINED, ',');
        bar.processKeyBinding(Keystrokes.character(','), event, JComponent.WHEN_IN_FOCUSED_WINDOW, false);
    }
}
