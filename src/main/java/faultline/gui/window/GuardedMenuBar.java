package faultline.gui.window;

import faultline.gui.action.Keystrokes;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;

/**
 * A menu bar whose items do not act on keys that are being typed into a text. Without it, a space typed into a field
 * would start the run, and the decimal point in a spinner would make a tick. Nor do they act on signs that are only to
 * be read, which would make two of one press.
 */
final class GuardedMenuBar extends JMenuBar {

    @Override
    protected boolean processKeyBinding(KeyStroke stroke, KeyEvent event, int condition, boolean pressed) {
        boolean typed = Keystrokes.isTypedInto(
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner(), stroke);
        return !typed
                && !Keystrokes.isMenuCharacter(stroke)
                && super.processKeyBinding(stroke, event, condition, pressed);
    }
}
