package faultline.gui.window;

import faultline.gui.action.ContextMenu;
import faultline.gui.settings.RecentFiles;
import faultline.gui.text.Messages;
import faultline.gui.text.TextDirection;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import java.awt.event.HierarchyEvent;
import java.awt.event.HierarchyListener;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JMenu;
import javax.swing.JMenuItem;

/** The menu of recently opened files, rebuilt each time the menu that contains it opens. */
final class RecentMenu extends JMenu {

    private final transient RecentFiles recentFiles;
    private final transient Consumer<Path> opener;

    RecentMenu(RecentFiles recentFiles, Consumer<Path> opener) {
        this.recentFiles = recentFiles;
        this.opener = opener;
        Menus.name(this, "recent");
        addHierarchyListener(new MenuFiller());
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
            JMenuItem clear = UiText.menuText(new JMenuItem(), "recent.clear");
            clear.addActionListener(event -> recentFiles.clear());
            add(clear);
        }
    }

    private JMenuItem createItem(int number, Path file) {
        JMenuItem item = new JMenuItem();
        String text = shortened(file.getFileName()) + "  –  " + shortened(file.getParent());
        ContextMenu.number(item, number, TextDirection.leftToRight(text));
        item.setToolTipText(file.toString());
        item.addActionListener(event -> opener.accept(file));
        return item;
    }

    private static String shortened(Path path) {
        return UiText.shortName(String.valueOf(path));
    }

    /**
     * Fills the menu when the menu that contains it is shown. Once this menu is being selected it is too late: Swing
     * has then chosen the item that is selected first, which would no longer be in the menu.
     */
    private final class MenuFiller implements HierarchyListener {
        @Override
        public void hierarchyChanged(HierarchyEvent event) {
            if ((event.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0 && isShowing()) {
                rebuild();
            }
        }
    }
}
