package faultline.gui.window;

import faultline.gui.action.Keystrokes;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;

/**
 * A menu bar whose accelerators do not act on keys that are being typed into a text component; otherwise a space in a
 * field would start the run. Accelerators that are shown in the menu but bound elsewhere are not handled here either,
 * because they would act twice.
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
