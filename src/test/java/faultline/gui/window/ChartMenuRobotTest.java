package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The context menu of the strip chart opens by mouse and keys, and exports the chart. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ChartMenuRobotTest {

    private WindowDriver driver;

    @TempDir
    private Path folder;

    @AfterEach
    void close() {
        driver.close();
    }

    private void open(Language language) {
        WindowDriver.installChoices(language, TextSize.NORMAL);
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    private JComponent chart() {
        return callOnEdt(() -> ComponentFinder.find(driver.window(), JComponent.class, Messages.get("strip.view")));
    }

    private void openMenu() {
        JComponent chart = chart();
        driver.robot().click(chart, chart.getWidth() / 2.0, chart.getHeight() / 2.0, InputEvent.BUTTON3_DOWN_MASK);
        driver.robot().waitFor("the menu shows", () -> WindowDriver.popupItems()
                .findAny()
                .isPresent());
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void itsItemsHaveDistinctMnemonics(Language language) {
        open(language);
        openMenu();
        List<JMenuItem> items = callOnEdt(() -> WindowDriver.popupItems().toList());
        assertEquals(9, items.size());
        List<Integer> letters = callOnEdt(
                () -> items.stream().map(JMenuItem::getMnemonic).distinct().toList());
        assertEquals(9, letters.size(), letters.toString());
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the menu closes", () -> WindowDriver.popupItems()
                .findAny()
                .isEmpty());
    }

    @Test
    void aKeyOpensItAndALetterExportsTheChart() {
        open(Language.ENGLISH);
        JComponent chart = chart();
        runOnEdt(chart::requestFocusInWindow);
        driver.robot().waitFor("the chart has the focus", chart::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_SHIFT, KeyEvent.VK_F10);
        driver.robot().waitFor("the menu shows", () -> WindowDriver.popupItems()
                .findAny()
                .isPresent());
        driver.robot().pressKeys(KeyEvent.VK_V);
        Path table = folder.resolve("chart.csv");
        driver.enterFile("Export chart values", table);
        driver.robot().waitFor("the table is written", () -> Files.exists(table));
    }
}
