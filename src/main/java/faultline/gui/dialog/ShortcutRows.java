package faultline.gui.dialog;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.text.Messages;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;

/** The keys of the actions and the gestures of the mouse, as rows of a table: where, what and its description. */
final class ShortcutRows {

    private final List<List<String>> rows = new ArrayList<>();
    private final Set<UiAction> listed = new LinkedHashSet<>();

    private ShortcutRows() {}

    /** Returns the rows: the actions in the order of the menus, then those without a menu, then the gestures. */
    static List<List<String>> of(JMenuBar menus, ActionRegistry actions) {
        ShortcutRows table = new ShortcutRows();
        for (int i = 0; i < menus.getMenuCount(); i++) {
            JMenu menu = menus.getMenu(i);
            table.addItems(menu.getText(), menu);
        }
        actions.allActions().forEach(action -> table.add("", action));
        table.addGestures(Messages.get("shortcuts.onCanvas"), "shortcuts.canvas");
        table.addGestures(Messages.get("timeline"), "shortcuts.lanes");
        return table.rows;
    }

    private void addGestures(String place, String key) {
        for (String gesture : Messages.get(key).split(";")) {
            String[] parts = gesture.split(":");
            rows.add(List.of(place, parts[0], parts[1]));
        }
    }

    private void addItems(String place, JMenu menu) {
        for (int i = 0; i < menu.getItemCount(); i++) {
            JMenuItem item = menu.getItem(i);
            if (item instanceof JMenu submenu) {
                addItems(place, submenu);
            } else if (item != null && item.getAction() instanceof UiAction action) {
                add(place, action);
            }
        }
    }

    private void add(String place, UiAction action) {
        if (listed.add(action)) {
            action.accelerator()
                    .ifPresent(stroke -> rows.add(List.of(
                            place,
                            Keystrokes.toText(stroke),
                            String.valueOf(action.getValue(UiAction.LONG_DESCRIPTION)))));
        }
    }
}
