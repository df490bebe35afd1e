package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Language;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The language and the text size change in an open window: afterwards it is the same as one that was opened with them,
 * and what the user has done in it stays.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class LiveChoicesRobotTest {

    private static final int TREE = 3;
    /** Enough for the next frame; a failing test then says what differs. */
    private static final int MAX_LOOKS = 300;

    private static final Path SCENARIO = Path.of("scenarios/yard.xml");

    private static WindowDriver open(Language language, TextSize size) {
        WindowDriver.installChoices(language, size);
        WindowPreferences preferences = WindowPreferences.nonPersistent();
        WindowDriver driver = WindowDriver.open(Theme.LIGHT, SCENARIO, preferences);
        runOnEdt(() -> driver.window().setSize(1280, 860));
        driver.robot().moveTo(callOnEdt(() -> driver.window().getJMenuBar()), 600, 5);
        driver.robot().waitForPaint();
        return driver;
    }

    private static List<String> texts(WindowDriver driver) {
        return callOnEdt(() -> textsNow(driver));
    }

    /**
     * What a user reads, with what a screen reader says, in the order of the components. Event dispatch thread only.
     */
    private static List<String> textsNow(WindowDriver driver) {
        return Stream.concat(
                        Stream.of(driver.window().getTitle()),
                        ComponentFinder.tree(driver.window()).flatMap(LiveChoicesRobotTest::textsOf))
                .toList();
    }

    /** Asserts that a window comes to have these texts; those of the readings change with the next frame. */
    private static void assertTexts(List<String> expected, WindowDriver driver) {
        waitUntilSettled(driver);
        AtomicInteger looks = new AtomicInteger();
        driver.robot()
                .waitFor(
                        "the texts have changed",
                        () -> looks.incrementAndGet() == MAX_LOOKS
                                || differences(expected, textsNow(driver)).isEmpty());
        assertEquals(List.of(), differences(expected, texts(driver)));
    }

    private static Stream<String> textsOf(Component part) {
        List<String> found = new ArrayList<>();
        if (part instanceof JLabel label) {
            found.add(label.getText());
        } else if (part instanceof AbstractButton button) {
            found.add(button.getText() + " " + (char) button.getMnemonic());
        } else if (part instanceof JTabbedPane tabs) {
            for (int i = 0; i < tabs.getTabCount(); i++) {
                found.add(tabs.getTitleAt(i) + ", " + tabs.getToolTipTextAt(i));
            }
        } else if (part instanceof JTable table) {
            for (int i = 0; i < table.getColumnCount(); i++) {
                found.add(String.valueOf(table.getColumnModel().getColumn(i).getHeaderValue()));
            }
        }
        if (part instanceof JComponent component) {
            found.add(component.getToolTipText());
        }
        if (part instanceof Accessible accessible) {
            AccessibleContext context = accessible.getAccessibleContext();
            found.add(context.getAccessibleName() + ", " + context.getAccessibleDescription());
        }
        return found.stream().map(text -> part.getClass().getSimpleName() + ": " + text);
    }

    /** The places of all components that show. */
    private static List<String> bounds(WindowDriver driver) {
        return callOnEdt(() -> Stream.of(
                        driver.window().getContentPane(), driver.window().getJMenuBar())
                .flatMap(ComponentFinder::tree)
                .filter(Component::isShowing)
                .map(part -> part.getClass().getSimpleName() + " " + ComponentFinder.accessibleName(part) + " "
                        + part.getBounds())
                .toList());
    }

    private static List<String> differences(List<String> expected, List<String> actual) {
        return IntStream.range(0, Math.max(expected.size(), actual.size()))
                .mapToObj(i ->
                        (i < expected.size() ? expected.get(i) : "") + " / " + (i < actual.size() ? actual.get(i) : ""))
                .filter(pair -> !pair.matches("(?s)(.*) / \\1"))
                .toList();
    }

    private static void waitUntilSettled(WindowDriver driver) {
        // Each refresh has fewer events than this, and each of them may request another layout.
        for (int i = 0; i < 3; i++) {
            driver.robot().waitForPaint();
        }
    }

    @Test
    void aChosenLanguageShowsAsIfTheWindowHadBeenOpenedWithIt() {
        List<String> english;
        List<String> polish;
        try (WindowDriver driver = open(Language.POLISH, TextSize.NORMAL)) {
            polish = texts(driver);
        }
        try (WindowDriver driver = open(Language.ENGLISH, TextSize.NORMAL)) {
            english = texts(driver);
            assertNotEquals(polish, english);
            driver.choose("languagePolish");
            assertTexts(polish, driver);
            driver.choose("languageEnglish");
            assertTexts(english, driver);
        }
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void aChosenTextSizeLaysTheWindowOutAsIfItHadBeenOpenedWithIt(Language language) {
        List<String> large;
        List<String> normal;
        try (WindowDriver driver = open(language, TextSize.LARGEST)) {
            large = bounds(driver);
        }
        try (WindowDriver driver = open(language, TextSize.NORMAL)) {
            normal = bounds(driver);
            driver.choose("textSizeLargest");
            waitUntilSettled(driver);
            assertEquals(List.of(), differences(large, bounds(driver)));
            driver.choose("textSizeNormal");
            waitUntilSettled(driver);
            assertEquals(List.of(), differences(normal, bounds(driver)));
        }
    }

    @Test
    void whatTheUserHasDoneStays() {
        try (WindowDriver driver = open(Language.ENGLISH, TextSize.NORMAL)) {
            driver.drag(TREE, 40, 0);
            List<JTabbedPane> tabs = callOnEdt(() ->
                    ComponentFinder.findAll(driver.window(), JTabbedPane.class).toList());
            runOnEdt(() -> tabs.forEach(pane -> pane.setSelectedIndex(pane.getTabCount() - 1)));
            JTextField field = ComponentFinder.find(driver.window(), JTextField.class, "x, m");
            driver.robot().waitFor("the form shows the selected obstacle", field::isEnabled);
            driver.click(field);
            driver.robot().waitFor("the field has the focus", field::isFocusOwner);
            JScrollPane scroll = callOnEdt(
                    () -> (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, field.getParent()));
            int scrolled = callOnEdt(() -> {
                scroll.getVerticalScrollBar().setValue(60);
                return scroll.getVerticalScrollBar().getValue();
            });
            String undo = callOnEdt(() -> undoText(driver));
            for (String choice : List.of("languagePolish", "textSizeLargest", "languageEnglish", "textSizeNormal")) {
                driver.choose(choice);
                waitUntilSettled(driver);
                driver.robot().waitFor("the field keeps the focus after " + choice, field::isFocusOwner);
            }
            assertEquals(undo, callOnEdt(() -> undoText(driver)));
            assertEquals(scrolled, callOnEdt(() -> scroll.getVerticalScrollBar().getValue()), 2);
            assertEquals(
                    List.of(),
                    tabs.stream()
                            .filter(pane -> callOnEdt(() -> pane.getSelectedIndex() == 0))
                            .toList());
            assertEquals(1, callOnEdt(() -> driver.canvas().tools().selected().size()));
            double before =
                    driver.frame().snapshot().obstacles().get(TREE).pose().x();
            driver.choose("undo");
            driver.waitForFrame(
                    "the move is undone",
                    frame -> frame.snapshot().obstacles().get(TREE).pose().x() < before);
        }
    }

    private static String undoText(WindowDriver driver) {
        return ComponentFinder.findAll(driver.window(), AbstractButton.class)
                .filter(button -> "undo".equals(button.getActionCommand()))
                .map(AbstractButton::getText)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void thePreferencesAndTheGuideFollowAtOnce() {
        try (WindowDriver driver = open(Language.ENGLISH, TextSize.NORMAL)) {
            driver.choose("guide");
            JDialog guide = driver.dialog("User guide");
            driver.chooseLater("preferences");
            JDialog preferences = driver.dialog("Preferences");
            assertMnemonicsAreUnique(preferences);
            JComboBox<?> language = ComponentFinder.find(preferences, JComboBox.class, "Language");
            driver.click(language);
            driver.robot().pressKeys(KeyEvent.VK_DOWN);
            driver.robot().pressKeys(KeyEvent.VK_ENTER);
            driver.robot()
                    .waitFor(
                            "the dialog is Polish", () -> preferences.getTitle().equals("Preferencje"));
            driver.robot().waitFor("the choice keeps the focus", language::isFocusOwner);
            driver.robot()
                    .waitFor("the guide is Polish", () -> !guide.getTitle().equals("User guide"));
            waitUntilSettled(driver);
            assertMnemonicsAreUnique(preferences);
            Dimension before = callOnEdt(preferences::getSize);
            int width = before.width;
            JComboBox<?> size = ComponentFinder.find(preferences, JComboBox.class, "Wielkość tekstu");
            runOnEdt(() -> size.setSelectedIndex(2));
            driver.robot().waitFor("the dialog has grown", () -> preferences.getWidth() > 1.2 * width);
            runOnEdt(() -> size.setSelectedIndex(0));
            driver.robot().waitFor("the dialog has shrunk", () -> preferences.getWidth() < 1.2 * width);
            waitUntilSettled(driver);
            assertEquals(before, callOnEdt(preferences::getSize), "as large as before");
            driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
            driver.robot().waitFor("the dialog is gone", () -> !preferences.isShowing());
        }
    }

    private static void assertMnemonicsAreUnique(JDialog dialog) {
        List<Integer> mnemonics = callOnEdt(() -> ComponentFinder.findAll(dialog, AbstractButton.class)
                .map(AbstractButton::getMnemonic)
                .filter(mnemonic -> mnemonic != 0)
                .toList());
        assertEquals(mnemonics.stream().distinct().toList(), mnemonics);
    }
}
