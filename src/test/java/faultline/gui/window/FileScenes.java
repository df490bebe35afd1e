package faultline.gui.window;

import static faultline.gui.GuiRobot.edt;

import faultline.gui.Components;
import faultline.gui.document.Recovery;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import javax.swing.JSlider;

/** Brings about what the window asks and tells about files, for pictures of it. */
final class FileScenes {

    private final WindowDriver driver;
    private final Path folder;
    private final Path office;

    FileScenes(WindowDriver driver) throws IOException {
        this.driver = driver;
        folder = Files.createTempDirectory("faultline");
        office = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
    }

    private void openOffice() {
        edt(() -> driver.window().open(office));
        driver.waitForTitle("office.xml");
        driver.waitForFrame("it shows", frame -> frame.world().tick() == 0);
    }

    /** By hand, so no tool may be in it. */
    private void edit() {
        edt(() -> driver.canvas().requestFocusInWindow());
        driver.robot().waitFor("the canvas has the focus", driver.canvas()::isFocusOwner);
        driver.robot().type(KeyEvent.VK_ESCAPE);
        driver.drag(0, 0, 20);
        driver.waitForTitle("office.xml*");
    }

    void broken() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.xml"),
                Files.readString(office).replaceFirst("<robot ", "<robot lenght=\"1\" speed=\"-1\" "));
        edt(() -> driver.window().open(broken));
    }

    void missing() {
        edt(() -> driver.window().open(folder.resolve("gone.xml")));
    }

    void unsaved() {
        openOffice();
        edit();
        driver.chooseLater("quit");
    }

    void revert() {
        driver.chooseLater("revert");
    }

    void changedUnsaved() throws IOException {
        Files.writeString(office, Files.readString(office).replaceFirst("<scenario ", "<scenario seed=\"7\" "));
        Files.setLastModifiedTime(office, FileTime.fromMillis(Files.getLastModifiedTime(office).toMillis() + 5000));
    }

    void recover() throws IOException {
        String home = System.getProperty("user.home");
        System.setProperty("user.home", folder.toString());
        String dead = Integer.MAX_VALUE - 7 + "-0";
        Path kept = Files.createDirectories(folder.resolve(".faultline/recovery"));
        Files.copy(office, kept.resolve(dead + ".xml"));
        Files.writeString(kept.resolve(dead + ".origin"), office.toString());
        edt(() -> driver.window().recover(Recovery.ofUser(), () -> { }));
        System.setProperty("user.home", home);
    }

    void replay() throws IOException {
        String text = Files.readString(Path.of("scenarios/office.xml"));
        Path run = Files.writeString(folder.resolve("long.xml"), text.replaceFirst("duration=\"180\"", "duration=\"36000\" recorded=\"true\""));
        edt(() -> driver.window().open(run));
        driver.waitForTitle("long.xml (replay)");
    }

    void longWay() {
        JSlider line = Components.named(driver.window(), JSlider.class, "Moment of the run");
        driver.robot().waitFor("there is a way to go", () -> line.getMaximum() > 0);
        edt(line::requestFocusInWindow);
        driver.robot().waitFor("the line has the focus", line::isFocusOwner);
        driver.robot().type(KeyEvent.VK_END);
    }

    void failedSave() throws IOException {
        openOffice();
        edit();
        Files.delete(office);
        Files.createDirectory(office);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    }

    /** The file as it was, and open. */
    void whole() throws IOException {
        Files.delete(office);
        Files.copy(Path.of("scenarios/office.xml"), office);
        openOffice();
    }
}
