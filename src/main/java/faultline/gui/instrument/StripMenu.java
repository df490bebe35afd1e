package faultline.gui.instrument;

import faultline.gui.action.ContextMenu;
import faultline.gui.action.ScrolledMenuLayout;
import faultline.gui.theme.UiText;
import java.awt.Component;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComboBox;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;

/** Builds the context menu of a strip chart, whose items do what the controls above the chart do. */
final class StripMenu {

    private final JPopupMenu menu = new JPopupMenu();

    /** Adds a submenu of the items of a combo box. */
    StripMenu choice(String key, JComboBox<?> box) {
        JMenu submenu = submenu(key);
        IntStream.range(0, box.getItemCount()).forEach(index -> {
            JMenuItem item = new JRadioButtonMenuItem("", index == box.getSelectedIndex());
            ContextMenu.number(item, index + 1, String.valueOf(box.getItemAt(index)));
            item.addActionListener(event -> box.setSelectedIndex(index));
            submenu.add(item);
        });
        return this;
    }

    /** Adds a submenu of items; it is disabled if there are none. */
    StripMenu items(String key, Stream<? extends Component> items) {
        JMenu submenu = submenu(key);
        items.forEach(submenu::add);
        submenu.setEnabled(submenu.getMenuComponentCount() > 0);
        return this;
    }

    private JMenu submenu(String key) {
        JMenu submenu = UiText.menuText(new JMenu(), key);
        ScrolledMenuLayout.install(submenu.getPopupMenu());
        menu.add(submenu);
        return submenu;
    }

    StripMenu separator() {
        menu.addSeparator();
        return this;
    }

    /** Adds an item that is checked as a button is, and clicks the button. */
    StripMenu toggle(String key, AbstractButton button) {
        JMenuItem item = UiText.menuText(new JCheckBoxMenuItem(), key);
        item.setSelected(button.isSelected());
        item.addActionListener(event -> button.doClick(0));
        menu.add(item);
        return this;
    }

    /** Adds an item that runs an action. */
    StripMenu action(String key, Runnable action) {
        JMenuItem item = UiText.menuText(new JMenuItem(), key);
        item.addActionListener(event -> action.run());
        menu.add(item);
        return this;
    }

    JPopupMenu menu() {
        return menu;
    }
}
