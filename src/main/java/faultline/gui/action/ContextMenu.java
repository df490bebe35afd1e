package faultline.gui.action;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.util.stream.Stream;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;

/** Shows context menus and numbers their items. */
public final class ContextMenu {

    private static final String MARKS = "123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";

    private ContextMenu() {}

    /**
     * Shows a menu at a position of a component. If a key requested it, its first enabled item is selected, as in the
     * menus of the menu bar.
     */
    public static void show(JPopupMenu menu, Component invoker, int x, int y) {
        boolean byKey = EventQueue.getCurrentEvent() instanceof KeyEvent;
        menu.show(invoker, x, y);
        if (byKey) {
            Stream.of(menu.getSubElements())
                    .filter(item -> item.getComponent().isEnabled())
                    .findFirst()
                    .ifPresent(first ->
                            MenuSelectionManager.defaultManager().setSelectedPath(new MenuElement[] {menu, first}));
        }
    }

    /**
     * Gives an item a number, counted from 1, before its name as its mnemonic, or a letter after the ninth; there is
     * nothing left for one after Z.
     */
    public static void number(JMenuItem item, int number, String name) {
        char mark = number <= MARKS.length() ? MARKS.charAt(number - 1) : ' ';
        item.setText(mark + "  " + name);
        item.setMnemonic(mark == ' ' ? 0 : mark);
    }
}
