package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Which characters reach what has the focus after a menu. */
class MenuKeyDispatcherTest {

    private final MenuKeyDispatcher dispatcher = new MenuKeyDispatcher();

    @AfterEach
    void closeMenuOnEdt() {
        runOnEdt(MenuKeyDispatcherTest::closeMenu);
    }

    @Test
    void theCharacterOfAKeyThatHasClosedAMenuIsDiscardedAndTheNextOneIsTyped() {
        runOnEdt(() -> {
            openMenu();
            assertFalse(dispatch(KeyEvent.KEY_PRESSED));
            closeMenu();
            assertTrue(dispatch(KeyEvent.KEY_TYPED));
            assertFalse(dispatch(KeyEvent.KEY_TYPED), "it has no press, as from an input method");
            assertFalse(dispatch(KeyEvent.KEY_RELEASED));
            assertFalse(dispatch(KeyEvent.KEY_PRESSED));
            assertFalse(dispatch(KeyEvent.KEY_TYPED));
        });
    }

    /** A submenu opens by the character of its mnemonic. */
    @Test
    void anOpenMenuGetsItsCharacters() {
        runOnEdt(() -> {
            openMenu();
            assertFalse(dispatch(KeyEvent.KEY_PRESSED));
            assertFalse(dispatch(KeyEvent.KEY_TYPED));
        });
    }

    @Test
    void aKeyWithoutACharacterThatWasPressedInAMenuLeavesTheNextCharacter() {
        runOnEdt(() -> {
            openMenu();
            assertFalse(dispatch(KeyEvent.KEY_PRESSED));
            assertFalse(dispatch(KeyEvent.KEY_RELEASED));
            closeMenu();
            assertFalse(dispatch(KeyEvent.KEY_TYPED));
        });
    }

    private static void openMenu() {
        MenuSelectionManager.defaultManager().setSelectedPath(new MenuElement[] {new JPopupMenu()});
    }

    private static void closeMenu() {
        MenuSelectionManager.defaultManager().clearSelectedPath();
    }

    private boolean dispatch(int id) {
        int key = id == KeyEvent.KEY_TYPED ? KeyEvent.VK_UNDEFINED : KeyEvent.VK_J;
        return dispatcher.dispatchKeyEvent(new KeyEvent(new JPanel(), id, 0, 0, key, 'j'));
    }
}
