package faultline.gui.action;

import java.awt.KeyEventDispatcher;
import java.awt.event.KeyEvent;
import javax.swing.MenuSelectionManager;

/**
 * Discards the character of a key that has closed a menu. The menu acts on the press of the key, and the character
 * comes afterwards, when a dialog or a text field may have the focus.
 */
public final class MenuKeyDispatcher implements KeyEventDispatcher {

    private boolean pressedInMenu;

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        boolean leftOver = event.getID() == KeyEvent.KEY_TYPED && pressedInMenu && !isMenuOpen();
        // A press and its character directly follow each other. Some characters of input methods have no press.
        pressedInMenu = event.getID() == KeyEvent.KEY_PRESSED && isMenuOpen();
        return leftOver;
    }

    private static boolean isMenuOpen() {
        return MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
    }
}
