package faultline.gui.window;

import faultline.gui.action.Keystrokes;
import faultline.gui.action.MenuKeyDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;

/**
 * A menu bar whose accelerators do not act on keys that are being typed into a text component; otherwise a space in a
 * field would start the run. Neither do they act on keys that are pressed for an item of an open menu. Accelerators
 * that are shown in the menu but bound elsewhere are not handled here either, because they would act twice. A character
 * that is typed while Ctrl is pressed is not treated as the character alone. While the bar is in a window that can be
 * shown, the character of a key that has closed a menu is discarded.
 */
final class GuardedMenuBar extends JMenuBar {

    private final transient MenuKeyDispatcher menuKeys = new MenuKeyDispatcher();

    @Override
    public void addNotify() {
        super.addNotify();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(menuKeys);
    }

    @Override
    public void removeNotify() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(menuKeys);
        super.removeNotify();
    }

    @Override
    protected boolean processKeyBinding(KeyStroke stroke, KeyEvent event, int condition, boolean pressed) {
        boolean typed = Keystrokes.isTypedInto(
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner(), stroke);
        return !typed
                && !isMeantForMenu(stroke)
                && !isShortcut(event)
                && !Keystrokes.isMenuCharacter(stroke)
                && super.processKeyBinding(stroke, event, condition, pressed);
    }

    /** Returns whether a stroke without Ctrl or Alt comes while a menu is open; it has no item for the stroke. */
    private static boolean isMeantForMenu(KeyStroke stroke) {
        return Keystrokes.producesText(stroke)
                && MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
    }

    /**
     * Returns whether a character comes with a key that makes it a shortcut; AltGr is Ctrl and Alt on some keyboards.
     */
    private static boolean isShortcut(KeyEvent event) {
        boolean ctrl = event.isControlDown() && !event.isAltDown() && !event.isAltGraphDown();
        return event.getID() == KeyEvent.KEY_TYPED && (ctrl || event.isMetaDown());
    }
}
