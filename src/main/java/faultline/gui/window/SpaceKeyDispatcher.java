package faultline.gui.window;

import faultline.gui.form.EnteredTextField;
import faultline.gui.form.NumberSpinner;
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
import javax.swing.text.Position;

/**
 * Makes Space run and pause the simulation although a button, a closed combo box, a tab, a list or a table has the
 * focus; otherwise it would press the control that was clicked last, or select a row that is mostly selected already.
 * Enter presses the focused button instead. Space also runs and pauses from a number field whose number is applied.
 * While an entry of a list is selected by its letters, Space is one of them. In other text fields, open menus and
 * dialogs, keys keep their usual meaning, and so does Space with other keys.
 */
final class SpaceKeyDispatcher implements KeyEventDispatcher {

    private final Component window;
    private final Runnable runOrPause;
    private final TypeAhead typeAhead = new TypeAhead();

    /**
     * The letters that have been typed into a list, each within a second of the one before, as the list counts them.
     */
    private static final class TypeAhead {
        private static final long MAX_MILLIS = 1000;

        /** Null before the first letter. */
        private JList<?> list;

        private String text = "";
        private long lastMillis;
        /** Whether the space that is pressed, or was pressed last, is one of the letters. */
        private boolean takesSpace;

        /** Notes a key, and returns whether it is a space that continues the beginning of an entry. */
        boolean takes(JList<?> focused, KeyEvent event) {
            boolean continued = focused == list && event.getWhen() - lastMillis < MAX_MILLIS;
            if (event.getID() == KeyEvent.KEY_TYPED) {
                text = continued ? text + event.getKeyChar() : String.valueOf(event.getKeyChar());
                list = focused;
                lastMillis = event.getWhen();
            } else if (event.getID() == KeyEvent.KEY_PRESSED) {
                takesSpace = isSpace(event) && continued && isBeginning();
            }
            return takesSpace && isSpace(event);
        }

        private boolean isBeginning() {
            return list.getModel().getSize() > 0 && list.getNextMatch(text, 0, Position.Bias.Forward) >= 0;
        }
    }

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
        boolean isCommand = event.isControlDown() || event.isAltDown() || event.isMetaDown();
        if (!isCommand && focused instanceof JList<?> list && isInside(list) && typeAhead.takes(list, event)) {
            // The press would end the selection by letters.
            return event.getID() != KeyEvent.KEY_TYPED;
        }
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
                || focused instanceof EnteredTextField entered && entered.isApplied()
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
