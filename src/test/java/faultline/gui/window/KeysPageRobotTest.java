package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.instrument.InstrumentDock;
import faultline.gui.instrument.StateDiagramView;
import faultline.gui.panel.ControlPanel;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.LaneView;
import faultline.gui.timeline.TimeBar;
import java.awt.Component;
import java.awt.Container;
import java.awt.FocusTraversalPolicy;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Everything in the window can be done by keys: each action has a path through the menus, Tab reaches each control, and
 * {@code docs/keys.md} lists both. If the page differs, the expected one is written to {@code target/keys.md}.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class KeysPageRobotTest {

    private static final Path PAGE = Path.of("docs/keys.md");
    private static final Path EXPECTED_PAGE = Path.of("target/keys.md");
    private static final String MENUS = "## Menus\n";
    private static final String CONTROLS = "## Controls\n";

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void thePageListsEveryActionAndControl() throws IOException {
        String page = Files.readString(PAGE);
        String introduction = page.substring(0, page.indexOf(MENUS));
        String expected = introduction + MENUS + callOnEdt(this::menuTable) + "\n" + CONTROLS + controlTable();
        if (!page.equals(expected)) {
            Files.createDirectories(EXPECTED_PAGE.getParent());
            Files.writeString(EXPECTED_PAGE, expected);
        }
        assertEquals(expected, page);
    }

    @Test
    void theMenuNamesTheKeysAsThePageDoes() {
        runOnEdt(() -> menuItems().values().forEach(item -> {
            KeyStroke stroke = item.getAccelerator();
            if (stroke != null) {
                String shown = stroke.getKeyCode() == KeyEvent.VK_UNDEFINED
                        ? String.valueOf(stroke.getKeyChar())
                        : KeyEvent.getKeyText(stroke.getKeyCode());
                assertTrue(Keystrokes.toText(stroke).endsWith(shown), item.getText() + ": " + shown);
            }
        }));
    }

    private String menuTable() {
        StringBuilder table = new StringBuilder("\n| Function | Menu | Key |\n| --- | --- | --- |\n");
        menuItems().forEach((path, item) -> table.append("| ")
                .append(name(item))
                .append(" | ")
                .append(path)
                .append(" | ")
                .append(key(item))
                .append(" |\n"));
        return table.toString();
    }

    /** Returns the text of an item, after that of its submenu if it is in one. */
    private static String name(JMenuItem item) {
        JMenu menu = (JMenu) ((JPopupMenu) item.getParent()).getInvoker();
        return menu.getParent() instanceof JPopupMenu ? menu.getText() + " > " + item.getText() : item.getText();
    }

    private static String key(JMenuItem item) {
        String key = item.getAction() instanceof UiAction action
                ? action.accelerator().map(Keystrokes::toText).orElse("")
                : "";
        return key.isEmpty() ? "" : kbd(key);
    }

    private static String kbd(String key) {
        return "<kbd>" + key + "</kbd>";
    }

    /** Returns the items of the menu bar by the keys that choose them. */
    private Map<String, JMenuItem> menuItems() {
        Map<String, JMenuItem> items = new LinkedHashMap<>();
        for (Component menu : driver.window().getJMenuBar().getComponents()) {
            String start = kbd("Alt+" + mnemonic((JMenu) menu));
            addItems((JMenu) menu, start, items);
        }
        return items;
    }

    private static void addItems(JMenu menu, String path, Map<String, JMenuItem> items) {
        Set<String> taken = new TreeSet<>();
        for (Component part : menu.getMenuComponents()) {
            if (part instanceof JMenuItem item && item.getAction() != null || part instanceof JMenu) {
                String mnemonic = mnemonic((JMenuItem) part);
                assertTrue(
                        mnemonic.isEmpty() || taken.add(mnemonic),
                        menu.getText() + " has two items with the mnemonic " + mnemonic);
                String here = path + (mnemonic.isEmpty() ? " " + kbd("Down") + " …" : " " + kbd(mnemonic));
                if (part instanceof RecentMenu recent) {
                    // Its items are files, which the digits choose.
                    items.put(here + " " + kbd("1") + " …", recent);
                } else if (part instanceof JMenu inner) {
                    addItems(inner, here, items);
                } else {
                    String unique = items.containsKey(here) ? here + " (" + items.size() + ")" : here;
                    items.put(unique, (JMenuItem) part);
                }
            }
        }
    }

    private static String mnemonic(JMenuItem item) {
        return item.getMnemonic() == 0 ? "" : String.valueOf((char) item.getMnemonic());
    }

    @Test
    void everyActionIsInTheMenuBar() {
        Set<String> inMenus = callOnEdt(() -> menuItems().values().stream()
                .filter(item -> item.getAction() != null)
                .map(item ->
                        item.getAction().getValue(UiAction.ACTION_COMMAND_KEY).toString())
                .collect(Collectors.toSet()));
        List<String> missing = callOnEdt(() -> driver.window().actions().allActions().stream()
                .filter(action -> action.accelerator().isEmpty() && !inMenus.contains(action.key()))
                .map(UiAction::key)
                .toList());
        assertEquals(List.of(), missing, "actions without a key and a menu item");
        List<String> onlyByMouse = callOnEdt(() -> ComponentFinder.findAll(driver.window(), AbstractButton.class)
                .filter(button -> !button.isFocusable() && button.getAction() instanceof UiAction)
                .map(button -> ((UiAction) button.getAction()).key())
                .filter(key -> !inMenus.contains(key))
                .toList());
        assertEquals(List.of(), onlyByMouse, "buttons without focus and without a menu item");
    }

    /** Returns the controls of each area and tab, all of which Tab reaches. */
    private String controlTable() {
        StringBuilder table = new StringBuilder("\n| Area | Controls |\n| --- | --- |\n");
        callOnEdt(() -> table.append(row("Speed", Optional.empty(), find(JSlider.class, "Speed")))
                .append(row("Canvas", Optional.empty(), driver.canvas()))
                .append(row("Time line", Optional.empty(), find(TimeBar.class)))
                .append(row("Lanes", Optional.empty(), find(LaneView.class))));
        for (JTabbedPane tabs : List.of(find(InstrumentDock.class), tabsOfPanel())) {
            for (int i = 0; i < callOnEdt(tabs::getTabCount); i++) {
                int tab = i;
                runOnEdt(() -> tabs.setSelectedIndex(tab));
                driver.robot().waitForPaint();
                table.append(
                        callOnEdt(() -> row(tabs.getTitleAt(tab), Optional.of(tabs), tabs.getSelectedComponent())));
            }
        }
        // The last tab has other controls with one obstacle selected than with several.
        for (String selection : List.of("selectNext", "selectAll")) {
            driver.choose(selection);
            boolean one = selection.equals("selectNext");
            driver.robot()
                    .waitFor(
                            "the fields follow the selection",
                            () -> find(JTextField.class, "x, m").isEnabled() == one);
            String name = one ? "Obstacles, one selected" : "Obstacles, several selected";
            table.append(
                    callOnEdt(() -> row(name, Optional.empty(), tabsOfPanel().getSelectedComponent())));
        }
        return table.toString();
    }

    private JTabbedPane tabsOfPanel() {
        return ComponentFinder.findAll(find(ControlPanel.class), JTabbedPane.class)
                .findFirst()
                .orElseThrow();
    }

    private <T extends Component> T find(Class<T> type) {
        return ComponentFinder.findAll(driver.window(), type).findFirst().orElseThrow();
    }

    private <T extends Component> T find(Class<T> type, String name) {
        return ComponentFinder.find(driver.window(), type, name);
    }

    private String row(String area, Optional<JTabbedPane> tabs, Component root) {
        Set<Component> reached = traversal();
        List<Component> controls = controls(root).toList();
        List<String> unreached = Stream.concat(tabs.stream(), controls.stream())
                .filter(control -> !reached.contains(control))
                .map(control -> control.getClass().getSimpleName() + " " + ComponentFinder.accessibleName(control))
                .toList();
        assertEquals(List.of(), unreached, area + ": not reached by Tab");
        String names = controls.stream()
                .map(ComponentFinder::accessibleName)
                .map(KeysPageRobotTest::generalised)
                .distinct()
                .collect(Collectors.joining("; "));
        return "| " + area + " | " + names + " |\n";
    }

    /** Returns a name without the id of its sensor. */
    private static String generalised(String name) {
        return name.replaceAll("\\b(front|rear)-(left|right)\\b", "SENSOR")
                .replaceAll("(of|Switch) (front|rear|left|right)\\b", "$1 SENSOR");
    }

    /** Returns what Tab reaches in the window, wherever it starts. */
    private Set<Component> traversal() {
        FocusTraversalPolicy policy = driver.window().getFocusTraversalPolicy();
        Set<Component> reached = new LinkedHashSet<>();
        Component next = policy.getFirstComponent(driver.window());
        while (next != null && reached.add(next)) {
            next = policy.getComponentAfter(driver.window(), next);
        }
        return reached;
    }

    private static Stream<Component> controls(Component root) {
        return ComponentFinder.tree(root)
                .filter(part -> part.isShowing() && part.isEnabled() && part.isFocusable())
                .filter(KeysPageRobotTest::isControl);
    }

    private static boolean isControl(Component part) {
        boolean inside = SwingUtilities.getAncestorOfClass(JComboBox.class, part) != null;
        return !inside
                && (part instanceof JTextField field && field.isEditable()
                        || part instanceof AbstractButton
                        || part instanceof JComboBox
                        || part instanceof JSlider
                        || part instanceof JTable
                        || part instanceof JList
                        || hasOwnKeys(part));
    }

    /** Returns whether a component has keys that do not come from its look and feel. */
    private static boolean hasOwnKeys(Component part) {
        return part instanceof JComponent component
                && !(part instanceof JTabbedPane)
                && !(part instanceof JScrollPane)
                && component.getInputMap(JComponent.WHEN_FOCUSED).keys() != null
                && component.getInputMap(JComponent.WHEN_FOCUSED).keys().length > 0;
    }

    @Test
    void thePageNamesEveryKeyOfTheCanvasTheLanesAndTheCharts() throws IOException {
        String page = Files.readString(PAGE);
        List<String> missing = new ArrayList<>();
        runOnEdt(() -> {
            Container window = driver.window();
            ComponentFinder.findAll(window, JComponent.class)
                    .filter(part -> part.isFocusable() && hasOwnKeys(part))
                    .filter(part -> !(part instanceof JSlider) && !(part instanceof AbstractButton))
                    .filter(part -> !(part instanceof JTextField) && !(part instanceof StateDiagramView))
                    .forEach(part -> Stream.of(
                                    part.getInputMap(JComponent.WHEN_FOCUSED).keys())
                            .map(KeysPageRobotTest::text)
                            .filter(key -> !page.contains(kbd(key)))
                            .forEach(key -> missing.add(part.getClass().getSimpleName() + " " + key)));
        });
        assertEquals(List.of(), missing);
    }

    private static String text(KeyStroke stroke) {
        return Keystrokes.toText(stroke);
    }

    @Test
    void theGuideNamesOnlyKeysThatThereAre() throws IOException {
        String page = Files.readString(PAGE);
        for (String guide : List.of("guide.html", "guide_pl.html")) {
            String text = Files.readString(Path.of("src/main/resources/faultline/gui", guide));
            assertTrue(text.contains("<b>F9</b>") && text.contains("<b>F6</b>"), guide);
            List<String> unknown = Stream.of(text.split("<b>"))
                    .skip(1)
                    .map(part -> part.substring(0, part.indexOf("</b>")))
                    .filter(key -> key.matches("F\\d+|Ctrl\\+.|[A-Z]|\\d|[.,\\[\\]]"))
                    .filter(key -> !page.contains(kbd(key)))
                    .toList();
            assertEquals(List.of(), unknown, guide);
        }
    }
}
