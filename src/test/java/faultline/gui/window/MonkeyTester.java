package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.GuiRobot;
import faultline.gui.canvas.SimulationCanvas;
import faultline.world.Obstacle;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import javax.swing.UIManager;

/**
 * Sends random mouse and key input to the window; the same seed gives the same input. It closes dialogs and menus that
 * open, by Escape alone, and never quits.
 */
final class MonkeyTester {

    private static final int[] BUTTONS = {
        InputEvent.BUTTON1_DOWN_MASK,
        InputEvent.BUTTON1_DOWN_MASK,
        InputEvent.BUTTON2_DOWN_MASK,
        InputEvent.BUTTON3_DOWN_MASK
    };
    private static final int[] KEYS = {
        KeyEvent.VK_PERIOD,
        KeyEvent.VK_COMMA,
        KeyEvent.VK_F,
        KeyEvent.VK_P,
        KeyEvent.VK_C,
        KeyEvent.VK_G,
        KeyEvent.VK_M,
        KeyEvent.VK_LEFT,
        KeyEvent.VK_RIGHT,
        KeyEvent.VK_UP,
        KeyEvent.VK_DELETE,
        KeyEvent.VK_1,
        KeyEvent.VK_2,
        KeyEvent.VK_3,
        KeyEvent.VK_7,
        KeyEvent.VK_OPEN_BRACKET,
        KeyEvent.VK_CLOSE_BRACKET,
        KeyEvent.VK_BACK_SLASH,
        KeyEvent.VK_TAB,
        KeyEvent.VK_I,
        KeyEvent.VK_I
    };
    private static final int[] DIALOG_KEYS = {
        KeyEvent.VK_TAB, KeyEvent.VK_DOWN, KeyEvent.VK_UP, KeyEvent.VK_LEFT, KeyEvent.VK_SPACE, KeyEvent.VK_ENTER
    };
    private static final int[] CONTROL_KEYS = {
        KeyEvent.VK_Z,
        KeyEvent.VK_Z,
        KeyEvent.VK_Y,
        KeyEvent.VK_0,
        KeyEvent.VK_EQUALS,
        KeyEvent.VK_MINUS,
        KeyEvent.VK_C,
        KeyEvent.VK_R
    };
    private static final List<String> OPENING =
            List.of("guide", "shortcuts", "about", "open", "exportPng", "saveAs", "examples");
    /** The actions that may ask something, or open another scenario, which is not in the hall of the other gestures. */
    private static final List<String> ASKING = List.of(
            "new",
            "importPlan",
            "revert",
            "saveJournal",
            "properties",
            "exportGif",
            "exportCsv",
            "exportChartPng",
            "preferences",
            "goToTime",
            "chooseController",
            "compareController",
            "openGhost",
            "openBatchResults",
            "record",
            "record",
            "motionSpeed",
            "keepGhost",
            "restart",
            "tour");

    private static final List<String> TEXTS = List.of("0.5", "-3", "1e9", "abc", "", "12");
    private static final int MAX_STEPS_IN_DIALOGS = 6;
    /** More than the dialogs and menus that can be open at once. */
    private static final int MAX_ESCAPES = 20;

    private static final List<String> SWITCHING =
            List.of("dark", "labels", "instruments", "hits", "routes", "snapGrid", "sensorsTwo", "sensorsAll");

    private final WindowDriver driver;
    private final GuiRobot robot;
    private final Random random;
    private final List<Runnable> gestures = List.of(
            this::click,
            this::drag,
            this::drag,
            this::dragAnObstacle,
            this::dragAnObstacle,
            this::dragAll,
            this::wheel,
            this::key,
            this::key,
            this::key,
            this::keyWithControl,
            this::keyWithControl,
            this::openMenu,
            this::openDialog,
            this::press,
            this::press,
            this::typeNumber,
            this::switchTab,
            this::scrub,
            this::toggle);

    MonkeyTester(WindowDriver driver, long seed) {
        this.driver = driver;
        this.robot = driver.robot();
        this.random = new Random(seed);
    }

    /** Performs a gesture, closes whatever it opened, and lets the run continue. */
    void performGesture() {
        gestures.get(random.nextInt(gestures.size())).run();
        closeAll();
        if (!driver.isRunning()) {
            robot.pressKeys(KeyEvent.VK_SPACE);
        }
    }

    /**
     * Chooses an action that may ask something, or performs another gesture, uses the dialogs that open, and closes
     * whatever is open. No file is written but the open one.
     */
    void performGestureAndAnswer() {
        if (random.nextBoolean()) {
            String action = any(ASKING);
            if (callOnEdt(() -> driver.isEnabled(action))) {
                driver.chooseLater(action);
                robot.waitForPaint();
            }
        } else {
            gestures.get(random.nextInt(gestures.size())).run();
        }
        for (int step = random.nextInt(MAX_STEPS_IN_DIALOGS); step > 0; step--) {
            callOnEdt(() -> dialogs().filter(Window::isFocused).findFirst()).ifPresent(this::useDialog);
        }
        closeAll();
        assertTrue(callOnEdt(() -> driver.window().isShowing()), "the window is gone");
        // What takes time, such as the start of a controller, may show another dialog later.
        robot.repeatUntil(
                "a component of the window has the focus",
                () -> driver.window().getFocusOwner() != null,
                this::closeAll);
    }

    /** Presses a button, enters a text or presses keys; of a choice of a file, only the button that cancels it. */
    private void useDialog(JDialog dialog) {
        boolean choosesFile = callOnEdt(() ->
                ComponentFinder.findAll(dialog, JFileChooser.class).findAny().isPresent());
        List<JButton> buttons = showing(dialog, JButton.class).stream()
                .filter(button -> !choosesFile
                        || UIManager.getString("FileChooser.cancelButtonText").equals(button.getText()))
                .toList();
        List<JTextField> fields = choosesFile ? List.of() : showing(dialog, JTextField.class);
        int kind = random.nextInt(3);
        if (kind == 0 && !buttons.isEmpty()) {
            driver.click(any(buttons));
        } else if (kind == 1 && !fields.isEmpty()) {
            driver.click(any(fields));
            robot.pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
            any(TEXTS).chars().forEach(letter -> robot.pressKeys(KeyEvent.getExtendedKeyCodeForChar(letter)));
        } else if (kind == 2 && !choosesFile) {
            robot.pressKeys(any(DIALOG_KEYS));
        }
    }

    private void click() {
        robot.click(canvas(), x(), y(), any(BUTTONS));
    }

    private void drag() {
        robot.drag(canvas(), x(), y(), x(), y(), any(BUTTONS));
    }

    private void dragAnObstacle() {
        List<Obstacle> obstacles = driver.frame().snapshot().obstacles();
        if (obstacles.isEmpty()) {
            return;
        }
        Obstacle obstacle = any(obstacles);
        Vector2 from =
                callOnEdt(() -> canvas().camera().toScreen(obstacle.pose().position()));
        if (callOnEdt(() -> canvas().contains((int) from.x(), (int) from.y()))) {
            robot.drag(
                    canvas(),
                    from.x(),
                    from.y(),
                    x(),
                    y(),
                    random.nextInt(4) == 0 ? InputEvent.BUTTON3_DOWN_MASK : InputEvent.BUTTON1_DOWN_MASK);
        }
    }

    private void dragAll() {
        robot.pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        dragAnObstacle();
        robot.pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        robot.pressKeys(KeyEvent.VK_ESCAPE);
    }

    private void wheel() {
        robot.moveTo(canvas(), x(), y());
        int way = random.nextBoolean() ? 1 : -1;
        for (int i = random.nextInt(6); i >= 0; i--) {
            robot.rotateWheel(way);
        }
    }

    private void key() {
        robot.pressKeys(any(KEYS));
    }

    private void keyWithControl() {
        robot.pressKeys(KeyEvent.VK_CONTROL, any(CONTROL_KEYS));
    }

    private void openMenu() {
        JMenuBar bar = callOnEdt(() -> driver.window().getJMenuBar());
        driver.click(any(callOnEdt(() ->
                Stream.of(bar.getComponents()).filter(JMenu.class::isInstance).toList())));
        for (int i = random.nextInt(8); i >= 0; i--) {
            robot.pressKeys(random.nextInt(5) == 0 ? KeyEvent.VK_RIGHT : KeyEvent.VK_DOWN);
        }
    }

    private void openDialog() {
        String action = any(OPENING);
        EventQueue.invokeLater(() -> driver.chooseOnEdt(action));
        robot.waitFor("a dialog shows", () -> dialogs().findAny().isPresent());
    }

    private void press() {
        List<AbstractButton> buttons = showing(AbstractButton.class);
        driver.click(any(buttons));
    }

    private void typeNumber() {
        List<JSpinner> spinners = showing(JSpinner.class);
        if (spinners.isEmpty()) {
            return;
        }
        JTextField field = callOnEdt(() -> ComponentFinder.findAll(any(spinners), JTextField.class)
                .findFirst()
                .orElseThrow());
        driver.click(field);
        robot.pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        robot.pressKeys(KeyEvent.VK_0 + random.nextInt(4));
        robot.pressKeys(KeyEvent.VK_PERIOD);
        robot.pressKeys(KeyEvent.VK_0 + random.nextInt(10));
        robot.pressKeys(KeyEvent.VK_ENTER);
        runOnEdt(canvas()::requestFocusInWindow);
    }

    private void switchTab() {
        List<JTabbedPane> panes = showing(JTabbedPane.class);
        if (!panes.isEmpty()) {
            runOnEdt(() -> {
                JTabbedPane pane = any(panes);
                pane.setSelectedIndex(random.nextInt(pane.getTabCount()));
            });
        }
    }

    private void scrub() {
        JSlider slider = any(showing(JSlider.class));
        Dimension size = callOnEdt(slider::getSize);
        robot.drag(
                slider,
                random.nextInt(size.width),
                size.height / 2.0,
                random.nextInt(size.width),
                size.height / 2.0,
                InputEvent.BUTTON1_DOWN_MASK);
    }

    private void toggle() {
        driver.choose(any(SWITCHING));
    }

    /** Closes menus and dialogs by Escape, which must not open others for ever. */
    private void closeAll() {
        List<String> escaped = new ArrayList<>();
        robot.repeatUntil(
                "all dialogs and menus are closed", () -> dialogs().findAny().isEmpty() && !isMenuOpen(), () -> {
                    // A window manager may give the focus to a dialog late, and the key goes to nobody before.
                    callOnEdt(() -> dialogs().filter(Window::isFocused).findFirst())
                            .ifPresent(dialog -> escaped.add(dialog.getTitle()));
                    assertTrue(escaped.size() <= MAX_ESCAPES, "Escape does not end: " + escaped);
                    robot.pressKeys(KeyEvent.VK_ESCAPE);
                });
        robot.pressKeys(KeyEvent.VK_ESCAPE);
    }

    private static boolean isMenuOpen() {
        MenuElement[] open = MenuSelectionManager.defaultManager().getSelectedPath();
        return open.length > 0;
    }

    private static Stream<JDialog> dialogs() {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(Window::isShowing);
    }

    private <C extends Component> List<C> showing(Class<C> type) {
        return showing(driver.window().getContentPane(), type);
    }

    private static <C extends Component> List<C> showing(Component root, Class<C> type) {
        return callOnEdt(() -> ComponentFinder.findAll(root, type)
                .filter(c -> c.isShowing() && c.isEnabled() && !c.getSize().equals(new Dimension()))
                .toList());
    }

    private SimulationCanvas canvas() {
        return driver.canvas();
    }

    private int x() {
        return random.nextInt(callOnEdt(canvas()::getWidth));
    }

    private int y() {
        return random.nextInt(callOnEdt(canvas()::getHeight));
    }

    private int any(int[] values) {
        return values[random.nextInt(values.length)];
    }

    private <T> T any(List<T> values) {
        return values.get(random.nextInt(values.size()));
    }
}
