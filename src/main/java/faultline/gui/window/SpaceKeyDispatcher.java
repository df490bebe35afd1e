package faultline.gui.window;

import faultline.gui.panel.NumberSpinner;
import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JFormattedTextField;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;

/**
 * Makes Space run and pause the simulation although a button, a closed combo box, a tab, a list or a table has the
 * focus; otherwise it would press the control that was clicked last, or select a row that is mostly selected already.
 * Enter presses the focused button instead. Space also runs and pauses from a number field whose number is applied. In
 * other text fields, open menus and dialogs, keys keep their usual meaning, and so does Space with other keys.
 */
final class SpaceKeyDispatcher implements KeyEventDispatcher {

    private final Component window;
    private final Runnable runOrPause;

    SpaceKeyDispatcher(Component window, Runnable runOrPause) {
        this.window = window;
        this.runOrPause = runOrPause;
    }

    /** Starts to dispatch keys until the window is closed. */
    void install(Window owner) {
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        manager.addKeyEventDispatcher(this);
        owner.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                manager.removeKeyEventDispatcher(SpaceKeyDispatcher.this);
            }
        });
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        Component focused = event.getComponent();
        boolean handled = event.getModifiersEx() == 0
                && isInside(focused)
                && MenuSelectionManager.defaultManager().getSelectedPath().length == 0
                && (isSpace(event) && takesSpace(focused) || isEnter(event) && focused instanceof AbstractButton);
        if (handled && event.getID() == KeyEvent.KEY_PRESSED) {
            if (isSpace(event)) {
                runOrPause.run();
            } else {
                ((AbstractButton) focused).doClick();
            }
        }
        return handled;
    }

    /** Returns whether a component is in the window itself; dialogs of the window count as its descendants. */
    private boolean isInside(Component focused) {
        return SwingUtilities.isDescendingFrom(focused, window) && windowOf(focused) == windowOf(window);
    }

    /** Returns the window of a component, null if it is in none. */
    private static Window windowOf(Component component) {
        return component instanceof Window self ? self : SwingUtilities.getWindowAncestor(component);
    }

    private static boolean takesSpace(Component focused) {
        return focused instanceof AbstractButton
                || focused instanceof JTabbedPane
                || focused instanceof JList
                || focused instanceof JTable
                || focused instanceof JComboBox<?> box && !box.isPopupVisible()
                || focused instanceof JFormattedTextField
                        && SwingUtilities.getAncestorOfClass(NumberSpinner.class, focused)
                                instanceof NumberSpinner number
                        && !number.isEdited();
    }

    private static boolean isSpace(KeyEvent event) {
        return isKey(event, KeyEvent.VK_SPACE, ' ');
    }

    private static boolean isEnter(KeyEvent event) {
        return isKey(event, KeyEvent.VK_ENTER, '\n');
    }

    private static boolean isKey(KeyEvent event, int code, char character) {
        return event.getID() == KeyEvent.KEY_TYPED ? event.getKeyChar() == character : event.getKeyCode() == code;
    }
}
