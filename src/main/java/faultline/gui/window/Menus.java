package faultline.gui.window;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.ObstacleActions;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.tool.MenuTarget;
import faultline.gui.text.Messages;
import java.util.List;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/** Creates the menu bar and the context menu of the canvas. */
final class Menus {

    private static final String SEPARATOR = "-";

    private final ActionRegistry actions;

    private Menus(ActionRegistry actions) {
        this.actions = actions;
    }

    static JMenuBar createMenuBar(ActionRegistry actions) {
        Menus menus = new Menus(actions);
        JMenuBar bar = new GuardedMenuBar();
        bar.add(menus.createFileMenu());
        bar.add(menus.createEditMenu());
        bar.add(menus.createViewMenu());
        bar.add(menus.createSimulationMenu());
        bar.add(menus.createObstacleMenu());
        bar.add(menus.createMenu("help", "guide", "shortcuts", SEPARATOR, "about"));
        return bar;
    }

    private JMenu createEditMenu() {
        return createMenu(
                "edit",
                "undo",
                "redo",
                SEPARATOR,
                "cut",
                "copy",
                "paste",
                "duplicate",
                "delete",
                SEPARATOR,
                "selectAll",
                "selectNext",
                "selectPrevious");
    }

    private JMenu createViewMenu() {
        JMenu view = createMenu(
                "view",
                "fit",
                "zoomIn",
                "zoomOut",
                "follow",
                "measure",
                SEPARATOR,
                "path",
                "cones",
                "hits",
                "routes",
                "labels",
                "grid",
                "scaleBar",
                SEPARATOR,
                "instruments",
                "nextArea",
                "previousArea",
                "dark");
        view.add(createMenu("language", "languageEnglish", "languagePolish"));
        view.add(createMenu("textSize", "textSizeNormal", "textSizeLarge", "textSizeLargest"));
        return view;
    }

    private JMenu createSimulationMenu() {
        JMenu simulation = createMenu(
                "simulation",
                "run",
                "step",
                "stepBack",
                "restart",
                SEPARATOR,
                "keepGhost",
                "openGhost",
                "removeGhost",
                SEPARATOR,
                "record",
                SEPARATOR,
                "slower",
                "faster",
                "realTime",
                SEPARATOR);
        simulation.add(createSensorMenu());
        simulation.add(createMenu("presets", "sensorsTwo", "sensorsThree", "sensorsAll"));
        return simulation;
    }

    private JMenu createObstacleMenu() {
        JMenu obstacles = createMenu("obstacles", ObstacleActions.PALETTE_KEYS.toArray(String[]::new));
        addItems(obstacles, SEPARATOR, "drawWay", "waySpeed", "standStill", SEPARATOR, "snapGrid", "snapAngle");
        return obstacles;
    }

    /** Creates the context menu of the canvas for what is under the cursor. */
    static JPopupMenu createCanvasPopup(ActionRegistry actions, MenuTarget target) {
        Menus menus = new Menus(actions);
        JPopupMenu popup = new JPopupMenu();
        for (String key : popupKeys(target)) {
            popup.add(key.equals(SEPARATOR) ? new JPopupMenu.Separator() : createItem(actions.get(key)));
        }
        if (target == MenuTarget.ROBOT || target == MenuTarget.SENSOR) {
            popup.add(menus.createSensorMenu());
            popup.add(menus.createMenu("presets", "sensorsTwo", "sensorsThree", "sensorsAll"));
        }
        return popup;
    }

    private static List<String> popupKeys(MenuTarget target) {
        return switch (target) {
            case OBSTACLE ->
                List.of("drawWay", "waySpeed", "standStill", SEPARATOR, "cut", "copy", "paste", "duplicate", "delete");
            case ROBOT -> List.of("follow", "path", "cones", SEPARATOR);
            case SENSOR -> List.of("cones", "hits", SEPARATOR);
            case FLOOR -> List.of("paste", "selectAll", SEPARATOR, "fit", "zoomIn", "zoomOut", "measure", "grid");
        };
    }

    private JMenu createSensorMenu() {
        return createMenu(
                "sensors", "sensor1", "sensor2", "sensor3", "sensor4", "sensor5", "sensor6", "sensor7", "sensor8");
    }

    private JMenu createFileMenu() {
        JMenu file =
                createMenu("file", "open", "examples", "revert", SEPARATOR, "save", "saveAs", "saveJournal", SEPARATOR);
        file.add(createMenu("export", "exportPng", "exportSvg", "exportGif", "exportCsv", SEPARATOR, "exportDark"));
        addItems(file, "copyPicture", "print", SEPARATOR, "quit");
        return file;
    }

    private JMenu createMenu(String key, String... items) {
        String name = Messages.get("menu." + key);
        JMenu menu = new JMenu(name.replace("&", ""));
        menu.setMnemonic(name.charAt(name.indexOf('&') + 1));
        addItems(menu, items);
        return menu;
    }

    private void addItems(JMenu menu, String... items) {
        for (String item : items) {
            if (item.equals(SEPARATOR)) {
                menu.addSeparator();
            } else {
                menu.add(createItem(actions.get(item)));
            }
        }
    }

    private static JMenuItem createItem(UiAction action) {
        JMenuItem item = action.isToggle() ? new JCheckBoxMenuItem(action) : new JMenuItem(action);
        item.setIcon(null);
        // The tool tip would cover the items below, and the name is enough.
        item.setToolTipText(null);
        return item;
    }
}
