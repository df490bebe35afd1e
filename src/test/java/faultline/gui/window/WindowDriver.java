package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;

import faultline.engine.Frame;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.BackgroundThreads;
import faultline.gui.ComponentFinder;
import faultline.gui.GuiRobot;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.text.SwingMessages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Palette;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.datatransfer.StringSelection;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;

/** Drives the window by what a user sees: its menus, its controls and the frame on its canvas. */
final class WindowDriver implements AutoCloseable {

    /** The number of speed steps that reach the highest speed. */
    private static final int MAX_SPEED_STEPS = 40;

    private static final long REST_NANOS = 150_000_000;

    private final GuiRobot robot = new GuiRobot();
    private final MainWindow window;

    private WindowDriver(Theme theme, WindowPreferences memory) {
        window = callOnEdt(() -> {
            theme.install();
            MainWindow made = new MainWindow(memory);
            // If the window manager chose the location, Java might not be notified of it, and the mouse would miss.
            made.setLocation(60, 40);
            return made;
        });
    }

    /** Opens a window with a scenario and waits until it is visible. */
    static WindowDriver open(Theme theme, Path scenario) {
        return open(theme, scenario, WindowPreferences.nonPersistent());
    }

    /** Opens a window with preferences. */
    static WindowDriver open(Theme theme, Path scenario, WindowPreferences memory) {
        WindowDriver driver = new WindowDriver(theme, memory);
        runOnEdt(() -> driver.window.open(scenario));
        driver.robot.open(driver.window);
        driver.robot.waitFor(
                "the first frame shows", () -> driver.canvas().frame().isPresent());
        return driver;
    }

    /** Opens a window without a scenario and waits until it has the focus. */
    static WindowDriver openEmpty() {
        WindowDriver driver = new WindowDriver(Theme.LIGHT, WindowPreferences.nonPersistent());
        driver.robot.open(driver.window);
        return driver;
    }

    /** Sets the language and the text size of all windows that are opened later, in the light theme. */
    static void installChoices(Language language, TextSize size) {
        runOnEdt(() -> {
            Messages.setLanguage(language);
            SwingMessages.install();
            size.install();
            Theme.LIGHT.install();
        });
    }

    GuiRobot robot() {
        return robot;
    }

    MainWindow window() {
        return window;
    }

    SimulationCanvas canvas() {
        return ComponentFinder.findAll(window, SimulationCanvas.class)
                .findFirst()
                .orElseThrow();
    }

    /** Returns the visible frame; callable on any thread. */
    Frame frame() {
        return callOnEdt(() -> canvas().frame().orElseThrow());
    }

    /** Waits until a reference run is visible. */
    void waitForReferenceRun() {
        robot.waitFor("the ghost is there", () -> canvas().renderRequest(Palette.LIGHT)
                .flatMap(request -> request.references().stream().findFirst())
                .isPresent());
    }

    /** Selects a menu item by the key of its action. */
    void choose(String action) {
        runOnEdt(() -> item(action).doClick(0));
    }

    /** Selects a menu item on the event dispatch thread, where it may block for a dialog. */
    void chooseOnEdt(String action) {
        item(action).doClick(0);
    }

    /** Selects a menu item that opens a modal dialog, without waiting. */
    void chooseLater(String action) {
        EventQueue.invokeLater(() -> chooseOnEdt(action));
    }

    /** Selects every tab in turn, and calls a visitor with its title when it has been painted. */
    void visitTabs(Consumer<String> visitor) {
        List<JTabbedPane> panes = callOnEdt(
                () -> ComponentFinder.findAll(window, JTabbedPane.class).toList());
        for (JTabbedPane tabs : panes) {
            for (int i = 0; i < callOnEdt(tabs::getTabCount); i++) {
                int tab = i;
                runOnEdt(() -> tabs.setSelectedIndex(tab));
                robot.waitForPaint();
                visitor.accept(callOnEdt(() -> tabs.getTitleAt(tab)));
            }
        }
    }

    /** Returns the note in the status bar. */
    String statusNote() {
        return ComponentFinder.find(window, JLabel.class, "Note").getText();
    }

    private JMenuItem item(String action) {
        return ComponentFinder.findAll(window, JMenuItem.class)
                .filter(item -> action.equals(item.getActionCommand()))
                .findFirst()
                .orElseThrow();
    }

    /** Returns whether a menu item is enabled. Event dispatch thread only. */
    boolean isEnabled(String action) {
        return item(action).isEnabled();
    }

    /** Waits for the dialog with a title to have the focus and returns it. */
    JDialog dialog(String title) {
        robot.waitFor(
                "the dialog \"" + title + "\" shows and has the focus",
                () -> dialogs(title).filter(Window::isFocused).findAny().isPresent());
        return callOnEdt(() -> dialogs(title).findAny().orElseThrow());
    }

    private static Stream<JDialog> dialogs(String title) {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(dialog -> dialog.isShowing() && dialog.getTitle().equals(title));
    }

    /** Clicks a button of a dialog and waits until the dialog is closed. */
    void clickButton(String title, String button) {
        JDialog dialog = dialog(title);
        click(ComponentFinder.findAll(dialog, JButton.class)
                .filter(one -> button.equals(one.getText()))
                .findFirst()
                .orElseThrow());
        robot.waitFor("the dialog \"" + title + "\" is gone", () -> !dialog.isShowing());
    }

    /** Pastes the name of a file into a file dialog, presses Enter, and waits until the dialog is closed. */
    void enterFile(String title, Path file) {
        JDialog dialog = typeFile(title, file);
        robot.waitFor("the dialog \"" + title + "\" is gone", () -> !dialog.isShowing());
    }

    /** Pastes the name of a file into a file dialog and presses Enter, after which the dialog may ask a question. */
    JDialog typeFile(String title, Path file) {
        JDialog dialog = dialog(title);
        JTextField name =
                ComponentFinder.findAll(dialog, JTextField.class).findFirst().orElseThrow();
        runOnEdt(() -> Toolkit.getDefaultToolkit()
                .getSystemClipboard()
                .setContents(new StringSelection(file.toString()), null));
        click(name);
        robot.waitFor("the name has the focus", name::isFocusOwner);
        robot.pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        robot.pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
        robot.waitFor("the name is there", () -> name.getText().equals(file.toString()));
        robot.pressKeys(KeyEvent.VK_ENTER);
        return dialog;
    }

    /** Presses keys as {@link GuiRobot#pressKeys}, after the window has gained the focus. */
    void type(int... keys) {
        robot.waitFor("the window has the focus", window::isFocused);
        robot.pressKeys(keys);
    }

    /** Waits until the window has a title. */
    void waitForTitle(String title) {
        robot.waitFor("the title is " + title, () -> window.getTitle().equals(title + " – Faultline"));
    }

    /** Returns the texts of all labels and text areas of a window. */
    static String text(Window window) {
        return callOnEdt(() -> Stream.concat(
                        ComponentFinder.findAll(window, JLabel.class).map(JLabel::getText),
                        ComponentFinder.findAll(window, JTextArea.class).map(JTextArea::getText))
                .collect(Collectors.joining(" ")));
    }

    /** Drags an obstacle by its centre; pixels to the right and down. */
    void drag(int index, int right, int down) {
        Pose pose = frame().snapshot().obstacles().get(index).pose();
        Vector2 at = callOnEdt(() -> canvas().camera().toScreen(pose.position()));
        robot.drag(canvas(), at.x(), at.y(), at.x() + right, at.y() + down, InputEvent.BUTTON1_DOWN_MASK);
        waitForFrame(
                "the obstacle is elsewhere",
                frame -> !frame.snapshot().obstacles().get(index).pose().equals(pose));
        waitUntilStill(index);
    }

    /** Waits until the last moves of a drag are visible, a few frames after the release. */
    private void waitUntilStill(int index) {
        AtomicReference<Pose> last = new AtomicReference<>(new Pose(0, 0, 0));
        AtomicLong since = new AtomicLong();
        waitForFrame("the obstacle is at rest", frame -> {
            Pose now = frame.snapshot().obstacles().get(index).pose();
            if (!now.equals(last.getAndSet(now))) {
                since.set(System.nanoTime());
            }
            return System.nanoTime() - since.get() > REST_NANOS;
        });
    }

    /** Resizes the window until the canvas has a size, pixels. */
    void resizeCanvas(int width, int height) {
        robot.waitFor("the canvas has its size", () -> {
            int wider = width - canvas().getWidth();
            int higher = height - canvas().getHeight();
            if (wider != 0 || higher != 0) {
                window.setBounds(0, 0, window.getWidth() + wider, window.getHeight() + higher);
            }
            return wider == 0 && higher == 0;
        });
    }

    /** Runs as fast as possible until the visible frame meets a condition; the run continues. */
    void runFast(Predicate<Frame> condition) {
        for (int i = 0; i < MAX_SPEED_STEPS; i++) {
            choose("faster");
        }
        choose("run");
        waitForFrame("the run has come far enough", condition);
    }

    /** Returns whether the run is running, as shown by the menu. */
    boolean isRunning() {
        return item("run").getText().equals("Pause");
    }

    /** Clicks the centre of a component. */
    void click(Component component) {
        Dimension size = callOnEdt(component::getSize);
        robot.click(component, size.width / 2.0, size.height / 2.0, InputEvent.BUTTON1_DOWN_MASK);
    }

    /** Clicks a number field and replaces its text by keys of {@link java.awt.event.KeyEvent}. */
    void typeInto(String spinner, int... keys) {
        JTextField field = ComponentFinder.find(window, JTextField.class, spinner);
        click(field);
        robot.waitFor("the field has the focus", field::isFocusOwner);
        robot.pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        for (int key : keys) {
            robot.pressKeys(key);
        }
    }

    /** Waits until the visible frame meets a condition. */
    void waitForFrame(String what, Predicate<Frame> condition) {
        robot.waitFor(what, () -> {
            Optional<Frame> frame = canvas().frame();
            return frame.isPresent() && condition.test(frame.get());
        });
    }

    /** Closes the window and waits until its work in the background has ended, which may write files of the test. */
    @Override
    public void close() {
        robot.close(window);
        BackgroundThreads.awaitEnd();
    }

    /** Returns the items of the open context menu; on the event dispatch thread. */
    static Stream<JMenuItem> popupItems() {
        return Stream.of(MenuSelectionManager.defaultManager().getSelectedPath())
                .filter(JPopupMenu.class::isInstance)
                .map(MenuElement::getSubElements)
                .flatMap(Stream::of)
                .filter(JMenuItem.class::isInstance)
                .map(JMenuItem.class::cast);
    }
}
