package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;

import faultline.gui.ComponentFinder;
import faultline.gui.theme.Theme;
import faultline.io.TemporaryFolder;
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
 * Writes pictures of the window, its instruments, menus and dialogs, light and dark, for the documentation;
 * {@code src/conf/screenshots} runs it for screens of one and of two pixels to a unit. Arguments: a scenario, a folder,
 * and the time at which the run is shown, seconds. Needs a display.
 */
public final class Screenshots {

    /** The actions that open dialogs. */
    private static final List<String> DIALOGS = List.of("guide", "shortcuts", "about", "open", "exportPng");

    private static final int EXAMPLES = 9;

    private final WindowDriver driver;
    private final Path folder;
    private final String suffix;

    private Screenshots(WindowDriver driver, Path folder, Theme theme) {
        this.driver = driver;
        this.folder = folder;
        double scale = callOnEdt(() ->
                driver.window().getGraphicsConfiguration().getDefaultTransform().getScaleX());
        suffix = "-" + theme.name().toLowerCase(Locale.ROOT) + (scale > 1 ? "-2x" : "") + ".png";
    }

    public static void main(String[] arguments) throws IOException, AWTException {
        Path folder = Files.createDirectories(Path.of(arguments[1]));
        for (Theme theme : Theme.values()) {
            Path opened = Files.createTempDirectory("faultline-screenshots-");
            try (WindowDriver driver = WindowDriver.open(theme, Path.of(arguments[0]))) {
                Screenshots pictures = new Screenshots(driver, folder, theme);
                pictures.prepare(Double.parseDouble(arguments[2]));
                pictures.takeWindow();
                pictures.takeMenus();
                pictures.takeDialogs(new FileDialogScenes(driver, opened));
                pictures.takeReferenceRun();
            } finally {
                TemporaryFolder.deleteTree(opened);
            }
        }
        System.exit(0);
    }

    private void takeWindow() throws IOException, AWTException {
        write(driver.window(), "window");
        JTabbedPane instruments = ComponentFinder.find(driver.window(), JTabbedPane.class, "Instruments");
        show(instruments, 1);
        write(instruments, "timing");
        show(instruments, 2);
        write(instruments, "events");
        runOnEdt(() -> instruments.setSelectedIndex(0));
        driver.choose("run");
        driver.choose("measure");
        driver.robot().drag(driver.canvas(), 220, 80, 420, 200, InputEvent.BUTTON1_DOWN_MASK);
        write(driver.canvas(), "measure");
        runOnEdt(() -> driver.canvas().tools().select(List.of()));
    }

    private void takeMenus() throws IOException, AWTException {
        for (JMenu menu : ComponentFinder.findAll(driver.window().getJMenuBar(), JMenu.class)
                .filter(menu -> menu.getParent() == driver.window().getJMenuBar())
                .toList()) {
            runOnEdt(() -> menu.doClick(0));
            driver.robot().waitFor("the menu shows", () -> menu.getPopupMenu().isShowing());
            write(menu.getPopupMenu(), "menu-" + callOnEdt(menu::getText).toLowerCase(Locale.ROOT));
            runOnEdt(MenuSelectionManager.defaultManager()::clearSelectedPath);
        }
    }

    /** Shows a ghost beside a run with a faulty sensor. */
    private void takeReferenceRun() throws IOException, AWTException {
        runOnEdt(() -> driver.canvas().requestFocusInWindow());
        driver.robot().waitFor("the canvas hears keys", driver.canvas()::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        restartAndRun(12);
        driver.waitForFrame(
                "the ghost's run is long enough", frame -> frame.snapshot().time() > 40);
        driver.choose("keepGhost");
        driver.waitForReferenceRun();
        driver.choose("run");
        restartAndRun(7);
        driver.waitForFrame(
                "the run follows the wall", frame -> frame.snapshot().time() > 14);
        inject("front");
        driver.waitForFrame("the runs have parted", frame -> frame.snapshot().time() > 32);
        driver.choose("run");
        write(driver.window(), "ghost");
    }

    private void restartAndRun(int faster) {
        driver.choose("realTime");
        for (int i = 0; i < faster; i++) {
            driver.choose("faster");
        }
        driver.choose("restart");
        driver.waitForFrame(
                "the run is at its start again", frame -> frame.snapshot().tick() == 0);
        driver.choose("run");
    }

    private void inject(String sensor) {
        runOnEdt(() -> {
            ComponentFinder.find(driver.window(), JComboBox.class, "Sensor").setSelectedItem(sensor);
            ComponentFinder.find(driver.window(), JButton.class, "Inject").doClick(0);
            driver.canvas().tools().clearSelection();
        });
    }

    private void takeDialogs(FileDialogScenes files) throws IOException, AWTException {
        for (String action : DIALOGS) {
            EventQueue.invokeLater(() -> driver.chooseOnEdt(action));
            writeDialog(action);
        }
        EventQueue.invokeLater(() -> driver.chooseOnEdt("examples"));
        JDialog gallery = dialog();
        driver.robot().waitFor("the examples are there", () -> ComponentFinder.findAll(gallery, JList.class)
                .anyMatch(list -> list.getModel().getSize() >= EXAMPLES));
        writeDialog("examples");
        takeFileDialogs(files);
    }

    private void takeFileDialogs(FileDialogScenes scenes) throws IOException, AWTException {
        scenes.openInvalidFile();
        writeDialog("broken-file");
        scenes.openMissingFile();
        writeDialog("missing-file");
        scenes.quitWithUnsavedChanges();
        writeDialog("unsaved");
        scenes.revert();
        writeDialog("revert");
        scenes.modifyFileExternally();
        writeDialog("changed-file");
        scenes.offerRecovery();
        writeDialog("recover");
        scenes.openReplay();
        write(driver.window(), "replay");
        scenes.seekFar();
        writeDialog("wait");
        scenes.failSave();
        writeDialog("failed-save");
        scenes.restoreFile();
    }

    private void writeDialog(String name) throws IOException, AWTException {
        JDialog dialog = dialog();
        write(dialog, "dialog-" + name);
        runOnEdt(dialog::dispose);
        driver.robot().waitFor("the dialog is gone", () -> showing().findAny().isEmpty());
    }

    private JDialog dialog() {
        driver.robot().waitFor("a dialog shows", () -> showing().findAny().isPresent());
        return callOnEdt(() -> showing().findFirst().orElseThrow());
    }

    private static Stream<JDialog> showing() {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(Window::isShowing);
    }

    private void prepare(double seconds) {
        inject("rear-right");
        driver.choose("sensor5");
        for (int i = 0; i < 7; i++) {
            driver.choose("faster");
        }
        driver.choose("run");
        driver.waitForFrame(
                "the run has come far enough", frame -> frame.snapshot().time() > seconds);
        driver.choose("realTime");
        double settled = driver.frame().snapshot().time() + 1.5;
        driver.waitForFrame("the pace has settled", frame -> frame.snapshot().time() > settled);
    }

    private void show(JTabbedPane instruments, int tab) {
        runOnEdt(() -> instruments.setSelectedIndex(tab));
        double shown = driver.frame().snapshot().time() + 0.5;
        driver.waitForFrame("the instrument shows", frame -> frame.snapshot().time() > shown);
    }

    /** Writes the part of the screen where a component is. */
    private void write(Component component, String name) throws IOException, AWTException {
        driver.robot().moveTo(driver.canvas(), 400, 300);
        driver.robot().waitForPaint();
        Rectangle bounds = callOnEdt(() -> new Rectangle(component.getLocationOnScreen(), component.getSize()));
        ImageIO.write(
                (RenderedImage) sharpest(new Robot().createMultiResolutionScreenCapture(bounds)),
                "png",
                folder.resolve(name + suffix).toFile());
    }

    /** Returns the variant with the most pixels. */
    private static Image sharpest(MultiResolutionImage image) {
        List<Image> variants = image.getResolutionVariants();
        return variants.get(variants.size() - 1);
    }
}
