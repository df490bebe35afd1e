package faultline.gui.window;

import static faultline.gui.GuiRobot.runOnEdt;

import faultline.gui.ComponentFinder;
import faultline.gui.document.RecoveryStore;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import javax.swing.JSlider;

/** Produces the file dialogs and messages of the window for screenshots. */
final class FileDialogScenes {

    private final WindowDriver driver;
    private final Path folder;
    private final Path office;

    /** Copies the office to an existing folder, to which all files of the scenes are written. */
    FileDialogScenes(WindowDriver driver, Path folder) throws IOException {
        this.driver = driver;
        this.folder = folder;
        office = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
    }

    private void openOffice() {
        runOnEdt(() -> driver.window().open(office));
        driver.waitForTitle("office.xml");
        driver.waitForFrame("it shows", frame -> frame.snapshot().tick() == 0);
    }

    /** Edits by drag, so no tool may be active. */
    private void edit() {
        runOnEdt(() -> driver.canvas().requestFocusInWindow());
        driver.robot().waitFor("the canvas has the focus", driver.canvas()::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.drag(0, 0, 20);
        driver.waitForTitle("office.xml*");
    }

    void openInvalidFile() throws IOException {
        Path broken = Files.writeString(
                folder.resolve("broken.xml"),
                Files.readString(office).replaceFirst("<robot ", "<robot lenght=\"1\" speed=\"-1\" "));
        runOnEdt(() -> driver.window().open(broken));
    }

    void openMissingFile() {
        runOnEdt(() -> driver.window().open(folder.resolve("gone.xml")));
    }

    void quitWithUnsavedChanges() {
        openOffice();
        edit();
        driver.chooseLater("quit");
    }

    void revert() {
        driver.chooseLater("revert");
    }

    void modifyFileExternally() throws IOException {
        Files.writeString(office, Files.readString(office).replaceFirst("<scenario ", "<scenario seed=\"7\" "));
        Files.setLastModifiedTime(
                office, FileTime.fromMillis(Files.getLastModifiedTime(office).toMillis() + 5000));
    }

    void offerRecovery() throws IOException {
        String home = System.getProperty("user.home");
        System.setProperty("user.home", folder.toString());
        String dead = Integer.MAX_VALUE - 7 + "-0";
        Path kept = Files.createDirectories(folder.resolve(".faultline/recovery"));
        Files.copy(office, kept.resolve(dead + ".xml"));
        Files.writeString(kept.resolve(dead + ".origin"), office.toString());
        runOnEdt(() -> driver.window().enableRecovery(RecoveryStore.forCurrentUser(), () -> {}));
        System.setProperty("user.home", home);
    }

    void openReplay() throws IOException {
        String text = Files.readString(Path.of("scenarios/office.xml"));
        Path run = Files.writeString(
                folder.resolve("long.xml"),
                text.replaceFirst("duration=\"180\"", "duration=\"36000\" recorded=\"true\""));
        runOnEdt(() -> driver.window().open(run));
        driver.waitForTitle("long.xml (replay)");
    }

    void seekFar() {
        JSlider line = ComponentFinder.find(driver.window(), JSlider.class, "Time line");
        driver.robot().waitFor("there is a way to go", () -> line.getMaximum() > 0);
        runOnEdt(line::requestFocusInWindow);
        driver.robot().waitFor("the line has the focus", line::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_END);
    }

    void failSave() throws IOException {
        openOffice();
        edit();
        Files.delete(office);
        Files.createDirectory(office);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    }

    /** Restores the file and opens it. */
    void restoreFile() throws IOException {
        Files.delete(office);
        Files.copy(Path.of("scenarios/office.xml"), office);
        openOffice();
    }
}
