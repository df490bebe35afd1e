package faultline.gui.window;

import faultline.gui.text.Texts;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/** Offers the files that were open last; filled anew each time it opens. */
final class RecentMenu extends JMenu {

    private final transient RecentFiles recent;
    private final transient Consumer<Path> opener;

    RecentMenu(RecentFiles recent, Consumer<Path> opener) {
        this.recent = recent;
        this.opener = opener;
        String name = Texts.text("menu.recent");
        setText(name.replace("&", ""));
        setMnemonic(Character.toUpperCase(name.charAt(name.indexOf('&') + 1)));
        addMenuListener(new Filler());
        fill();
    }

    private void fill() {
        removeAll();
        List<Path> files = recent.files();
        for (int i = 0; i < files.size(); i++) {
            add(item(i + 1, files.get(i)));
        }
        if (files.isEmpty()) {
            add(new JMenuItem(Texts.text("recent.none"))).setEnabled(false);
        } else {
            addSeparator();
            add(new JMenuItem(Texts.text("recent.clear"))).addActionListener(event -> recent.clear());
        }
    }

    private JMenuItem item(int number, Path file) {
        JMenuItem item = new JMenuItem(number + "  " + file.getFileName() + "  –  " + file.getParent());
        item.setMnemonic('0' + number);
        item.addActionListener(event -> opener.accept(file));
        return item;
    }

    /** Fills the menu in time. */
    private final class Filler implements MenuListener {
        @Override
        public void menuSelected(MenuEvent event) {
            fill();
        }

        @Override
        public void menuDeselected(MenuEvent event) {
            // Stays filled.
        }

        @Override
        public void menuCanceled(MenuEvent event) {
            // Stays filled.
        }
    }
}
