package faultline.gui.window;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.ContextMenu;
import faultline.gui.action.ObstacleActions;
import faultline.gui.action.ScrolledMenuLayout;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.canvas.tool.MenuTarget;
import faultline.gui.theme.UiText;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/** Creates the menu bar and the context menu of the canvas, and adds to that of the strip chart. */
final class Menus {

    private static final String SEPARATOR = "-";
    private static final String CHART_EXPORTS = "exportChartPng exportChartSvg exportChartCsv - exportDark";

    private final ActionRegistry actions;

    private Menus(ActionRegistry actions) {
        this.actions = actions;
    }

    static JMenuBar createMenuBar(ActionRegistry actions) {
        Menus menus = new Menus(actions);
        JMenuBar bar = new GuardedMenuBar();
        bar.add(menus.createFileMenu());
        bar.add(menus.createMenu(
                "edit",
                "undo redo - cut copy paste duplicate delete addSensor"
                        + " - selectAll selectNext selectPrevious - preferences"));
        bar.add(menus.createViewMenu());
        bar.add(menus.createSimulationMenu());
        String palette = String.join(" ", ObstacleActions.PALETTE_KEYS);
        bar.add(menus.createMenu(
                "obstacles", palette + " - drawWaypoints motionSpeed stopMoving - snapGrid snapAngle"));
        bar.add(menus.createMenu("help", "tour guide shortcuts - about"));
        return bar;
    }

    private JMenu createFileMenu() {
        JMenu file = createMenu("file", "new open examples importPlan revert - save saveAs saveJournal properties -");
        file.add(createMenu("export", "exportPng exportSvg exportGif exportCsv - " + CHART_EXPORTS));
        addItems(file, "copyPicture print - quit");
        return file;
    }

    private JMenu createViewMenu() {
        JMenu view = createMenu(
                "view",
                "fit zoomIn zoomOut follow measure - path pathStates pathFaults"
                        + " cones hits routes labels grid scaleBar"
                        + " - timeline instruments controlPanel nextArea previousArea dark");
        view.add(createMenu("lanes", "lanesZoomIn lanesZoomOut lanesWhole"));
        view.add(createMenu("language", "languageEnglish languagePolish"));
        view.add(createMenu("textSize", "textSizeNormal textSizeLarge textSizeLargest"));
        return view;
    }

    private JMenu createSimulationMenu() {
        JMenu simulation = createMenu(
                "simulation",
                "run step stepBack previousEvent nextEvent goToTime restart"
                        + " - chooseController scenarioController batch openBatchResults"
                        + " - keepGhost openGhost compareController removeGhost - record - slower faster realTime -");
        simulation.add(createSensorMenu());
        simulation.add(createPresetMenu());
        return simulation;
    }

    private JMenu createSensorMenu() {
        JMenu menu = createMenu("sensors", "sensor1 sensor2 sensor3 sensor4 sensor5 sensor6 sensor7 sensor8");
        // A menu is not empty, so the first item stays even if the robot has no sensors.
        for (int i = 1; i < menu.getItemCount(); i++) {
            showWhileEnabled(menu.getItem(i));
        }
        return menu;
    }

    private static void showWhileEnabled(JMenuItem item) {
        item.setVisible(item.isEnabled());
        item.addPropertyChangeListener("enabled", event -> item.setVisible(item.isEnabled()));
    }

    private JMenu createPresetMenu() {
        return createMenu("presets", "sensorsTwo sensorsThree sensorsAll");
    }

    /** Lets the canvas show a context menu for the item under the cursor. */
    static void installContextMenu(SimulationCanvas canvas, ActionRegistry actions, RobotMenu robotMenu) {
        canvas.tools().listeners().addMenuListener(at -> {
            MenuTarget target = canvas.tools().targetAt(at);
            JPopupMenu popup = new JPopupMenu();
            if (target == MenuTarget.SENSOR) {
                canvas.tools().selectSensorAt(at).ifPresent(sensor -> robotMenu.addSensor(popup, sensor));
            } else if (target == MenuTarget.ROBOT) {
                canvas.tools().directionOf(at).ifPresent(direction -> robotMenu.addNewSensor(popup, direction));
                canvas.frame()
                        .ifPresent(frame ->
                                robotMenu.addMotors(popup, frame.snapshot().motorFaults()));
            }
            addCanvasItems(popup, actions, target);
            ContextMenu.show(popup, canvas, at.x, at.y);
        });
    }

    /** Adds the menu items for the item of the canvas under the cursor to a context menu. */
    static void addCanvasItems(JPopupMenu popup, ActionRegistry actions, MenuTarget target) {
        Menus menus = new Menus(actions);
        addItems(popup, actions, popupKeys(target));
        if (target == MenuTarget.ROBOT || target == MenuTarget.SENSOR) {
            popup.add(menus.createSensorMenu());
            popup.add(menus.createPresetMenu());
        }
    }

    /** Adds the exports of the strip chart to its context menu. */
    static void addChartItems(JPopupMenu popup, ActionRegistry actions) {
        popup.addSeparator();
        addItems(popup, actions, CHART_EXPORTS);
    }

    private static void addItems(JPopupMenu popup, ActionRegistry actions, String keys) {
        for (String key : keys.split(" ")) {
            popup.add(key.equals(SEPARATOR) ? new JPopupMenu.Separator() : createItem(actions.get(key)));
        }
    }

    private static String popupKeys(MenuTarget target) {
        return switch (target) {
            case OBSTACLE -> "drawWaypoints motionSpeed stopMoving - cut copy paste duplicate delete";
            case ROBOT -> "follow path cones -";
            case SENSOR -> "cones hits -";
            case FLOOR -> "paste selectAll - fit zoomIn zoomOut measure grid";
        };
    }

    /** Creates a menu; {@code items} are the keys of its actions, separated by spaces. */
    private JMenu createMenu(String key, String items) {
        JMenu menu = new JMenu();
        name(menu, key);
        addItems(menu, items);
        return menu;
    }

    /** Gives a menu the name and the mnemonic of a key, and lets it scroll. */
    static void name(JMenu menu, String key) {
        ScrolledMenuLayout.install(menu.getPopupMenu());
        UiText.menuText(menu, "menu." + key);
    }

    private void addItems(JMenu menu, String items) {
        for (String item : items.split(" ")) {
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
        item.addPropertyChangeListener(JComponent.TOOL_TIP_TEXT_KEY, event -> item.setToolTipText(null));
        item.setToolTipText(null);
        return item;
    }
}
