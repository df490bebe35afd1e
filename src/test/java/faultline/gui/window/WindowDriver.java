package faultline.gui.window;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;

import faultline.engine.Frame;
import faultline.gui.Components;
import faultline.gui.GuiRobot;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.JMenuItem;
import javax.swing.JTextField;

/** Drives the whole window by what a user sees of it: its menus, its controls and the frame that its canvas shows. */
final class WindowDriver implements AutoCloseable {

    private final GuiRobot robot = new GuiRobot();
    private final SimulatorFrame window;

    private WindowDriver(Theme theme) {
        window = onEdt(() -> {
            theme.install();
            SimulatorFrame made = new SimulatorFrame(WindowMemory.none());
            // Where the window manager chooses the place, Java now and then never learns of it, and the mouse misses.
            made.setLocation(60, 40);
            return made;
        });
    }

    /** Opens a window with a scenario, and waits until it shows. */
    static WindowDriver open(Theme theme, Path scenario) {
        WindowDriver driver = new WindowDriver(theme);
        edt(() -> driver.window.open(scenario));
        driver.robot.open(driver.window);
        driver.robot.waitFor("the first frame shows", () -> driver.canvas().frame().isPresent());
        return driver;
    }

    GuiRobot robot() {
        return robot;
    }

    SimulatorFrame window() {
        return window;
    }

    SimulationCanvas canvas() {
        return Components.all(window, SimulationCanvas.class).findFirst().orElseThrow();
    }

    /** The frame that shows; on any thread. */
    Frame frame() {
        return onEdt(() -> canvas().frame().orElseThrow());
    }

    /** Chooses a menu item by the key of its action. */
    void choose(String action) {
        edt(() -> item(action).doClick(0));
    }

    /** Does the same on the event dispatch thread, where it may wait for a dialog. */
    void chooseNow(String action) {
        item(action).doClick(0);
    }

    private JMenuItem item(String action) {
        return Components.all(window, JMenuItem.class).filter(item -> action.equals(item.getActionCommand())).findFirst().orElseThrow();
    }

    /** Whether time runs, as the menu has it. */
    boolean isRunning() {
        return item("run").getText().equals("Pause");
    }

    /** Clicks on the middle of a component. */
    void click(Component component) {
        Dimension size = onEdt(component::getSize);
        robot.click(component, size.width / 2.0, size.height / 2.0, InputEvent.BUTTON1_DOWN_MASK);
    }

    /** Puts the focus into a field for a number by clicking on it, and types keys of {@link java.awt.event.KeyEvent} in place of what is there. */
    void typeInto(String spinner, int... keys) {
        JTextField field = Components.named(window, JTextField.class, spinner);
        click(field);
        robot.waitFor("the field has the focus", field::isFocusOwner);
        robot.type(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        for (int key : keys) {
            robot.type(key);
        }
    }

    /** What a condition of the shown frame waits for. */
    void waitForFrame(String what, Predicate<Frame> condition) {
        robot.waitFor(what, () -> {
            Optional<Frame> frame = canvas().frame();
            return frame.isPresent() && condition.test(frame.get());
        });
    }

    @Override
    public void close() {
        robot.close(window);
    }
}
