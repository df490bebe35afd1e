package faultline.gui.window;

import faultline.gui.settings.RecentFiles;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/** The menu of recently opened files, rebuilt each time it opens. */
final class RecentMenu extends JMenu {

    private final transient RecentFiles recentFiles;
    private final transient Consumer<Path> opener;

    RecentMenu(RecentFiles recent, Consumer<Path> opener) {
        this.recentFiles = recent;
        this.opener = opener;
        Menus.name(this, "recent");
        addMenuListener(new MenuFiller());
        RefreshSteps.add(this, RecentMenu::rebuild);
    }

    private void rebuild() {
        removeAll();
        List<Path> files = recentFiles.files();
        for (int i = 0; i < files.size(); i++) {
            add(createItem(i + 1, files.get(i)));
        }
        if (files.isEmpty()) {
            add(new JMenuItem(Messages.get("recent.none"))).setEnabled(false);
        } else {
            addSeparator();
            add(new JMenuItem(Messages.get("recent.clear"))).addActionListener(event -> recentFiles.clear());
        }
    }

    private JMenuItem createItem(int number, Path file) {
        JMenuItem item = new JMenuItem(number + "  " + file.getFileName() + "  –  " + file.getParent());
        item.setMnemonic('0' + number);
        item.addActionListener(event -> opener.accept(file));
        return item;
    }

    /** Fills the menu before it is shown. */
    private final class MenuFiller implements MenuListener {
        @Override
        public void menuSelected(MenuEvent event) {
            rebuild();
        }

        @Override
        public void menuDeselected(MenuEvent event) {
            // Nothing to do.
        }

        @Override
        public void menuCanceled(MenuEvent event) {
            // Nothing to do.
        }
    }
}
