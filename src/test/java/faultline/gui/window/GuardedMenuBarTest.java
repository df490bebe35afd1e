package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.action.Keystrokes;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GuardedMenuBarTest {

    /** The desktop types a comma for Ctrl+comma, too. */
    @ParameterizedTest
    @CsvSource({"0, true", "128, false", "256, false", "8704, true"})
    void aCharacterWithTheMenuKeyIsNotTheCharacterAlone(int modifiers, boolean acts) {
        boolean acted = callOnEdt(() -> {
            boolean[] chosen = {false};
            JMenuItem item = new JMenuItem("Step back");
            item.setAccelerator(Keystrokes.character(','));
            item.addActionListener(event -> chosen[0] = true);
            JMenu menu = new JMenu("Run");
            menu.add(item);
            GuardedMenuBar bar = new GuardedMenuBar();
            bar.add(menu);
            KeyEvent event = new KeyEvent(bar, KeyEvent.KEY_TYPED, 0, modifiers, KeyEvent.VK_UNDEFINED, ',');
            bar.processKeyBinding(Keystrokes.character(','), event, JComponent.WHEN_IN_FOCUSED_WINDOW, false);
            return chosen[0];
        });
        assertEquals(acts, acted, () -> InputEvent.getModifiersExText(modifiers));
    }
}
