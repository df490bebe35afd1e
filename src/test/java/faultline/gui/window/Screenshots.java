package faultline.gui.window;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;

import faultline.gui.Components;
import faultline.gui.theme.Theme;
import java.awt.AWTException;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.MultiResolutionImage;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JTabbedPane;
import javax.swing.MenuSelectionManager;

/**
 * Writes pictures of the window, its instruments, menus and dialogs, light and dark, for the documentation; {@code src/conf/screenshots}
 * runs it for screens of one and of two pixels to a unit. Arguments: a scenario, a folder, and how far the run is to have come in seconds.
 * Needs a display.
 */
public final class Screenshots {

    /** Dialogs that an action opens, by the action. */
    private static final List<String> DIALOGS = List.of("guide", "shortcuts", "about", "open", "exportPng");
    private static final int EXAMPLES = 9;

    private final WindowDriver driver;
    private final Path folder;
    private final String suffix;

    private Screenshots(WindowDriver driver, Path folder, Theme theme) {
        this.driver = driver;
        this.folder = folder;
        double scale = onEdt(() -> driver.window().getGraphicsConfiguration().getDefaultTransform().getScaleX());
        suffix = "-" + theme.name().toLowerCase(Locale.ROOT) + (scale > 1 ? "-2x" : "") + ".png";
    }

    public static void main(String[] arguments) throws IOException, AWTException {
        Path folder = Files.createDirectories(Path.of(arguments[1]));
        for (Theme theme : Theme.values()) {
            try (WindowDriver driver = WindowDriver.open(theme, Path.of(arguments[0]))) {
                Screenshots pictures = new Screenshots(driver, folder, theme);
                pictures.prepare(Double.parseDouble(arguments[2]));
                pictures.takeWindow();
                pictures.takeMenus();
                pictures.takeDialogs();
                pictures.takeGhost();
            }
        }
        System.exit(0);
    }

    private void takeWindow() throws IOException, AWTException {
        write(driver.window(), "window");
        JTabbedPane instruments = Components.named(driver.window(), JTabbedPane.class, "Instruments");
        show(instruments, 1);
        write(instruments, "timing");
        show(instruments, 2);
        write(instruments, "events");
        edt(() -> instruments.setSelectedIndex(0));
        driver.choose("run");
        driver.choose("measure");
        driver.robot().drag(driver.canvas(), 220, 80, 420, 200, InputEvent.BUTTON1_DOWN_MASK);
        write(driver.canvas(), "measure");
        edt(() -> driver.canvas().tools().select(List.of()));
    }

    private void takeMenus() throws IOException, AWTException {
        for (JMenu menu : Components.all(driver.window().getJMenuBar(), JMenu.class)
                .filter(menu -> menu.getParent() == driver.window().getJMenuBar()).toList()) {
            edt(() -> menu.doClick(0));
            driver.robot().waitFor("the menu shows", () -> menu.getPopupMenu().isShowing());
            write(menu.getPopupMenu(), "menu-" + onEdt(menu::getText).toLowerCase(Locale.ROOT));
            edt(MenuSelectionManager.defaultManager()::clearSelectedPath);
        }
    }

    /** A run as a ghost beside one in which a sensor lies. */
    private void takeGhost() throws IOException, AWTException {
        edt(() -> driver.canvas().requestFocusInWindow());
        driver.robot().waitFor("the canvas hears keys", driver.canvas()::isFocusOwner);
        driver.robot().type(KeyEvent.VK_ESCAPE);
        runAnew(12);
        driver.waitForFrame("the ghost's run is long enough", frame -> frame.world().time() > 40);
        driver.choose("keepGhost");
        driver.waitForGhost();
        driver.choose("run");
        runAnew(7);
        driver.waitForFrame("the run follows the wall", frame -> frame.world().time() > 14);
        inject("front");
        driver.waitForFrame("the runs have parted", frame -> frame.world().time() > 32);
        driver.choose("run");
        write(driver.window(), "ghost");
    }

    private void runAnew(int faster) {
        driver.choose("realTime");
        for (int i = 0; i < faster; i++) {
            driver.choose("faster");
        }
        driver.choose("restart");
        driver.waitForFrame("the run begins anew", frame -> frame.world().tick() == 0);
        driver.choose("run");
    }

    private void inject(String sensor) {
        edt(() -> {
            Components.named(driver.window(), JComboBox.class, "Sensor").setSelectedItem(sensor);
            Components.named(driver.window(), JButton.class, "Inject").doClick(0);
            driver.canvas().tools().selectSensor(Optional.empty());
        });
    }

    private void takeDialogs() throws IOException, AWTException {
        for (String action : DIALOGS) {
            EventQueue.invokeLater(() -> driver.chooseNow(action));
            writeDialog(action);
        }
        EventQueue.invokeLater(() -> driver.chooseNow("examples"));
        JDialog gallery = dialog();
        driver.robot().waitFor("the examples are there",
                () -> Components.all(gallery, JList.class).anyMatch(list -> list.getModel().getSize() >= EXAMPLES));
        writeDialog("examples");
        takeFileDialogs(new FileScenes(driver));
    }

    private void takeFileDialogs(FileScenes scenes) throws IOException, AWTException {
        scenes.broken();
        writeDialog("broken-file");
        scenes.missing();
        writeDialog("missing-file");
        scenes.unsaved();
        writeDialog("unsaved");
        scenes.revert();
        writeDialog("revert");
        scenes.changedUnsaved();
        writeDialog("changed-file");
        scenes.recover();
        writeDialog("recover");
        scenes.replay();
        write(driver.window(), "replay");
        scenes.longWay();
        writeDialog("wait");
        scenes.failedSave();
        writeDialog("failed-save");
        scenes.whole();
    }

    private void writeDialog(String name) throws IOException, AWTException {
        JDialog dialog = dialog();
        write(dialog, "dialog-" + name);
        edt(dialog::dispose);
        driver.robot().waitFor("the dialog is gone", () -> showing().findAny().isEmpty());
    }

    private JDialog dialog() {
        driver.robot().waitFor("a dialog shows", () -> showing().findAny().isPresent());
        return onEdt(() -> showing().findFirst().orElseThrow());
    }

    private static Stream<JDialog> showing() {
        return Stream.of(Window.getWindows()).filter(JDialog.class::isInstance).map(JDialog.class::cast).filter(Window::isShowing);
    }

    private void prepare(double seconds) {
        inject("rear-right");
        driver.choose("sensor5");
        for (int i = 0; i < 12; i++) {
            driver.choose("faster");
        }
        driver.choose("run");
        driver.waitForFrame("the run has come far enough", frame -> frame.world().time() > seconds);
        driver.choose("realTime");
        double settled = driver.frame().world().time() + 1.5;
        driver.waitForFrame("the pace has settled", frame -> frame.world().time() > settled);
    }

    private void show(JTabbedPane instruments, int tab) {
        edt(() -> instruments.setSelectedIndex(tab));
        double shown = driver.frame().world().time() + 0.5;
        driver.waitForFrame("the instrument shows", frame -> frame.world().time() > shown);
    }

    /** What is on the screen where a component is. */
    private void write(Component component, String name) throws IOException, AWTException {
        driver.robot().moveTo(driver.canvas(), 400, 300);
        driver.robot().waitForPaint();
        Rectangle bounds = onEdt(() -> new Rectangle(component.getLocationOnScreen(), component.getSize()));
        ImageIO.write((RenderedImage) sharpest(new Robot().createMultiResolutionScreenCapture(bounds)), "png",
                folder.resolve(name + suffix).toFile());
    }

    /** Of a screen with several pixels to a unit, all of them. */
    private static Image sharpest(MultiResolutionImage image) {
        List<Image> variants = image.getResolutionVariants();
        return variants.get(variants.size() - 1);
    }
}
