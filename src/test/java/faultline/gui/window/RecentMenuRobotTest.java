package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Theme;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.swing.JDialog;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Opens recent files from the menu by keys. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class RecentMenuRobotTest {

    @TempDir
    private Path folder;

    private Path office;
    private Path square;
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        office = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        square = Files.copy(Path.of("scenarios/collision-on-purpose.xml"), folder.resolve("square.xml"));
        Map<String, String> texts = new HashMap<>();
        driver = WindowDriver.open(
                Theme.LIGHT,
                office,
                new WindowPreferences(
                        new WindowPreferences.PreferenceStore(key -> texts.getOrDefault(key, ""), texts::put)));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void recentFilesAreListedNewestFirstAndAMissingOneIsReportedAndRemoved() throws IOException {
        runOnEdt(() -> driver.window().open(square));
        driver.waitForTitle("square.xml");
        assertEquals(List.of("1  square.xml", "2  office.xml"), recent());
        Files.delete(office);
        chooseRecent(KeyEvent.VK_2);
        JDialog dialog = driver.dialog("Scenario not opened");
        String text = WindowDriver.text(dialog);
        assertTrue(text.contains("office.xml cannot be opened: there is no such file"), text);
        assertTrue(text.contains("The current scenario remains open."), text);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertEquals(List.of("1  square.xml"), recent());
        assertEquals("square.xml – Faultline", callOnEdt(driver.window()::getTitle));
    }

    @Test
    void aRecentFileIsOpenedFromTheMenuByKeys() {
        runOnEdt(() -> driver.window().open(square));
        driver.waitForTitle("square.xml");
        chooseRecent(KeyEvent.VK_2);
        driver.waitForTitle("office.xml");
    }

    @Test
    void theArrowKeysStartAtTheNewestOfTheRecentFiles() {
        runOnEdt(() -> driver.window().open(square));
        driver.waitForTitle("square.xml");
        chooseRecent(KeyEvent.VK_DOWN);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("office.xml");
    }

    @Test
    void theListIsClearedByItsMnemonic() {
        chooseRecent(KeyEvent.VK_C);
        assertEquals(List.of(), recent());
    }

    /** Alt+F, R, and a key such as the number before the file. */
    private void chooseRecent(int key) {
        RecentMenu menu = openFileMenu();
        driver.robot().pressKeys(callOnEdt(menu::getMnemonic));
        driver.robot().waitFor("the list is open", () -> menu.getPopupMenu().isShowing());
        driver.robot().pressKeys(key);
    }

    private RecentMenu openFileMenu() {
        driver.type(KeyEvent.VK_ALT, KeyEvent.VK_F);
        RecentMenu menu = recentMenu();
        driver.robot().waitFor("the menu is open", menu::isShowing);
        return menu;
    }

    private RecentMenu recentMenu() {
        return callOnEdt(() -> ComponentFinder.findAll(driver.window(), RecentMenu.class)
                .findFirst()
                .orElseThrow());
    }

    private List<String> recent() {
        RecentMenu menu = openFileMenu();
        List<String> files = callOnEdt(() -> ComponentFinder.findAll(menu, JMenuItem.class)
                .map(JMenuItem::getText)
                .filter(text -> text.matches("\\d .*"))
                .map(text -> text.substring(0, text.indexOf("  –")))
                .toList());
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the menu is closed", () -> !menu.isShowing());
        return files;
    }
}
