package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.form.NumberSpinner;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.ToolTipManager;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Every dialog can be used by keyboard and screen reader: each control has a name, Tab reaches it, and Esc closes the
 * dialog.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class DialogAccessRobotTest {

    @TempDir
    private Path folder;

    private final int tipDelay = callOnEdt(() -> ToolTipManager.sharedInstance().getInitialDelay());
    private Path file;
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        driver = WindowDriver.open(Theme.LIGHT, file);
    }

    @AfterEach
    void close() {
        setTipDelay(tipDelay);
        driver.close();
    }

    @ParameterizedTest
    @CsvSource({
        "guide, User guide",
        "shortcuts, Keyboard and mouse",
        "about, About Faultline",
        "open, Open scenario",
        "saveAs, Save scenario",
        "saveJournal, Save journal",
        "exportPng, Export image",
        "examples, Examples",
        "preferences, Preferences",
        "chooseController, Choose a controller"
    })
    void aDialogOfAnActionIsNamedReachedAndClosedByKeys(String action, String title) {
        driver.chooseLater(action);
        check(title);
    }

    @ParameterizedTest
    @ValueSource(ints = {420, 700})
    void theTextsOfTheShortcutsWrapInADialogOfAnyWidth(int width) {
        driver.chooseLater("shortcuts");
        JDialog dialog = driver.dialog("Keyboard and mouse");
        runOnEdt(() -> dialog.setSize(width, 480));
        driver.robot().waitFor("the dialog has its size", () -> dialog.getWidth() == width);
        JTextArea heading =
                ComponentFinder.findAll(dialog, JTextArea.class).findFirst().orElseThrow();
        driver.robot()
                .waitFor(
                        "the heading shows all of its text",
                        () -> heading.getHeight() >= heading.getUI().getPreferredSize(heading).height);
        JTable table = ComponentFinder.findAll(dialog, JTable.class).findFirst().orElseThrow();
        driver.robot().waitFor("each row has the height of its texts", () -> IntStream.range(0, table.getRowCount())
                .allMatch(row -> table.getRowHeight(row) == highestCell(table, row)));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
    }

    private static int highestCell(JTable table, int row) {
        return IntStream.range(0, table.getColumnCount())
                .map(column -> {
                    Component cell = table.prepareRenderer(table.getCellRenderer(row, column), row, column);
                    cell.setSize(table.getColumnModel().getColumn(column).getWidth(), Short.MAX_VALUE);
                    return cell.getPreferredSize().height;
                })
                .max()
                .orElseThrow();
    }

    /** The tool tip manager consumes Escape while it believes that it shows a tip. */
    @ParameterizedTest
    @CsvSource({"shortcuts, Keyboard and mouse", "examples, Examples"})
    void escapeClosesADialogAlsoWhileTheMouseRestsOnIt(String action, String title) {
        setTipDelay(0);
        driver.robot().moveTo(driver.canvas(), 300, 200);
        driver.robot().moveTo(driver.canvas(), 310, 205);
        driver.chooseLater(action);
        JDialog dialog = driver.dialog(title);
        Component list = callOnEdt(() -> controls(dialog)
                .filter(part -> part instanceof JTable || part instanceof JList)
                .findFirst()
                .orElseThrow());
        driver.robot().moveSmoothly(list, 20, 20, 60, 50);
        driver.robot().waitForPaint();
        runOnEdt(list::requestFocusInWindow);
        driver.robot().waitFor("the list has the focus", list::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
    }

    private static void setTipDelay(int millis) {
        runOnEdt(() -> ToolTipManager.sharedInstance().setInitialDelay(millis));
    }

    @Test
    void enterClosesADialogAlsoWhileItsTableHasTheFocus() {
        driver.chooseLater("shortcuts");
        JDialog dialog = driver.dialog("Keyboard and mouse");
        JTable table = ComponentFinder.findAll(dialog, JTable.class).findFirst().orElseThrow();
        runOnEdt(table::requestFocusInWindow);
        driver.robot().waitFor("the table has the focus", table::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
    }

    @Test
    void escapeClosesAFormAndEnterAcceptsItAlsoWhileANumberIsTyped() {
        typeDuration(KeyEvent.VK_ESCAPE);
        assertEquals("office.xml – Faultline", callOnEdt(driver.window()::getTitle));
        typeDuration(KeyEvent.VK_ENTER);
        driver.waitForTitle("office.xml*");
    }

    private void typeDuration(int lastKey) {
        driver.chooseLater("properties");
        JDialog dialog = driver.dialog("Scenario properties");
        JTextField duration = callOnEdt(() ->
                ComponentFinder.find(dialog, NumberSpinner.class, "Duration, s").textField());
        driver.click(duration);
        driver.robot().waitFor("the field has the focus", duration::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        driver.robot().pressKeys(KeyEvent.VK_9);
        driver.robot().pressKeys(lastKey);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
    }

    @Test
    void theQuestionsAboutUnsavedChangesAreNamedAndReachedByKeys() {
        driver.drag(0, 0, 30);
        driver.waitForTitle("office.xml*");
        driver.chooseLater("revert");
        check("Revert");
        driver.chooseLater("quit");
        check("Unsaved changes");
    }

    @Test
    void theArrowKeysMoveBetweenTheAnswersOfAQuestion() {
        driver.drag(0, 0, 30);
        driver.waitForTitle("office.xml*");
        driver.chooseLater("quit");
        JDialog dialog = driver.dialog("Unsaved changes");
        List<JButton> answers =
                callOnEdt(() -> ComponentFinder.findAll(dialog, JButton.class).toList());
        driver.robot()
                .waitFor("the first answer has the focus", () -> answers.get(0).isFocusOwner());
        for (int next : new int[] {1, 2, 0}) {
            driver.robot().pressKeys(KeyEvent.VK_RIGHT);
            driver.robot().waitFor("Right moves to answer " + next, () -> answers.get(next)
                    .isFocusOwner());
        }
        driver.robot().pressKeys(KeyEvent.VK_LEFT);
        driver.robot()
                .waitFor("Left moves to the last answer", () -> answers.get(2).isFocusOwner());
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("Enter gives the focused answer", () -> !dialog.isShowing());
        assertTrue(callOnEdt(driver.window()::isShowing), "the last answer is to cancel");
    }

    @Test
    void theProblemsOfAnInvalidFileAreNamedAndReachedByKeys() throws IOException {
        Path broken = Files.writeString(
                folder.resolve("broken.xml"), Files.readString(file).replaceFirst("<robot ", "<robot lenght=\"1\" "));
        runOnEdt(() -> driver.window().open(broken));
        check("Scenario not opened");
    }

    @Test
    void theMessageAboutAMissingFileIsNamedAndReachedByKeys() {
        runOnEdt(() -> driver.window().open(folder.resolve("gone.xml")));
        check("Scenario not opened");
    }

    private void check(String title) {
        JDialog dialog = driver.dialog(title);
        List<Component> controls = callOnEdt(() -> controls(dialog).toList());
        assertTrue(!controls.isEmpty(), "there is something to press");
        assertEquals(List.of(), callOnEdt(() -> controls.stream()
                .filter(control -> ComponentFinder.accessibleName(control).isBlank())
                .map(Component::getClass)
                .toList()));
        Set<Component> reached = new HashSet<>();
        for (int i = 0; i < 2 * controls.size() + 4; i++) {
            reached.add(callOnEdt(
                    () -> KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner()));
            driver.robot().pressKeys(KeyEvent.VK_TAB);
        }
        assertEquals(
                List.of(),
                controls.stream()
                        .filter(control -> !reached.contains(control))
                        .map(ComponentFinder::accessibleName)
                        .toList(),
                "not reached");
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
    }

    /**
     * Returns the controls of a dialog; the arrow of a combo box is part of it. The text of an editable one has the
     * focus instead of it.
     */
    private static Stream<Component> controls(JDialog dialog) {
        return ComponentFinder.tree(dialog.getContentPane())
                .filter(DialogAccessRobotTest::isControl)
                .filter(part -> part.isFocusable()
                        && part.isShowing()
                        && part.isEnabled()
                        && !(part instanceof JComboBox<?> box && box.isEditable())
                        && !(part instanceof AbstractButton && part.getParent() instanceof JComboBox))
                .filter(part -> !isOneOfAGroup(part));
    }

    /** Returns whether Tab reaches the selected button of a group only; arrows reach the others. */
    private static boolean isOneOfAGroup(Component part) {
        return part instanceof JToggleButton button
                && ((JToggleButton.ToggleButtonModel) button.getModel()).getGroup() != null
                && !button.isSelected();
    }

    private static boolean isControl(Component part) {
        return Stream.of(AbstractButton.class, JTextComponent.class, JTable.class, JList.class, JComboBox.class)
                .anyMatch(kind -> kind.isInstance(part));
    }
}
