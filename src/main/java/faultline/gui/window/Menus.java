package faultline.gui.window;

import faultline.gui.action.UiAction;
import faultline.gui.text.Texts;
import java.util.List;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/** The menu bar. */
final class Menus {

    private static final String RULE = "-";

    private final UiActions actions;

    private Menus(UiActions actions) {
        this.actions = actions;
    }

    static JMenuBar of(UiActions actions) {
        Menus menus = new Menus(actions);
        JMenuBar bar = new GuardedMenuBar();
        bar.add(menus.file());
        bar.add(menus.menu("edit", "undo", "redo", RULE, "cut", "copy", "paste", "duplicate", "delete", RULE, "selectAll"));
        JMenu view = menus.menu("view", "fit", "zoomIn", "zoomOut", "follow", "measure", RULE, "path", "cones", "hits", "routes", "labels", "grid",
                "scaleBar", RULE, "instruments", "dark");
        view.add(menus.menu("language", "languageEnglish", "languagePolish"));
        view.add(menus.menu("textSize", "textSizeNormal", "textSizeLarge", "textSizeLargest"));
        bar.add(view);
        JMenu simulation = menus.menu("simulation", "run", "step", "stepBack", "restart", RULE, "keepGhost", "openGhost", "removeGhost",
                RULE, "record", RULE, "slower", "faster", "realTime", RULE);
        simulation.add(menus.menu("sensors", "sensor1", "sensor2", "sensor3", "sensor4", "sensor5", "sensor6", "sensor7", "sensor8"));
        simulation.add(menus.menu("presets", "sensorsTwo", "sensorsThree", "sensorsAll"));
        bar.add(simulation);
        bar.add(menus.obstacles());
        bar.add(menus.menu("help", "guide", "shortcuts", RULE, "about"));
        return bar;
    }

    private JMenu obstacles() {
        JMenu obstacles = menu("obstacles", ObstacleActions.PALETTE.toArray(String[]::new));
        fill(obstacles, RULE, "drawWay", "waySpeed", "standStill", RULE, "snapGrid", "snapAngle");
        return obstacles;
    }

    /** What can be done to what is selected, beside the mouse. */
    static JPopupMenu onCanvas(UiActions actions) {
        JPopupMenu popup = new JPopupMenu();
        for (String key : List.of("drawWay", "waySpeed", "standStill", RULE, "cut", "copy", "paste", "duplicate", "delete")) {
            popup.add(key.equals(RULE) ? new JPopupMenu.Separator() : item(actions.get(key)));
        }
        return popup;
    }

    private JMenu file() {
        JMenu file = menu("file", "open", "examples", "revert", RULE, "save", "saveAs", "saveJournal", RULE);
        file.add(menu("export", "exportPng", "exportSvg", "exportGif", "exportCsv", RULE, "exportDark"));
        fill(file, "copyPicture", "print", RULE, "quit");
        return file;
    }

    private JMenu menu(String key, String... items) {
        String name = Texts.text("menu." + key);
        JMenu menu = new JMenu(name.replace("&", ""));
        menu.setMnemonic(name.charAt(name.indexOf('&') + 1));
        fill(menu, items);
        return menu;
    }

    private void fill(JMenu menu, String... items) {
        for (String item : items) {
            if (item.equals(RULE)) {
                menu.addSeparator();
            } else {
                menu.add(item(actions.get(item)));
            }
        }
    }

    private static JMenuItem item(UiAction action) {
        JMenuItem item = action.isToggle() ? new JCheckBoxMenuItem(action) : new JMenuItem(action);
        item.setIcon(null);
        // The name says it, and a tip would cover the items below.
        item.setToolTipText(null);
        return item;
    }
}
