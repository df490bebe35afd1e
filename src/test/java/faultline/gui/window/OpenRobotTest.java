package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Camera;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.Component;
import java.awt.Window;
import java.awt.dnd.DnDConstants;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Opens scenarios in a real window in all possible ways, and tests the questions before changes are discarded. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class OpenRobotTest {

    @TempDir
    private Path folder;

    private Path office;
    private Path square;
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        office = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        square = Files.copy(Path.of("scenarios/collision-on-purpose.xml"), folder.resolve("square.xml"));
        driver = WindowDriver.open(Theme.LIGHT, office);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void aFileIsOpenedByItsName() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_O);
        driver.enterFile("Open scenario", square);
        driver.waitForTitle("square.xml");
    }

    @Test
    void aRestartKeepsTheViewAndAnotherScenarioIsFitted() throws IOException {
        Camera fitted = callOnEdt(() -> driver.canvas().camera());
        runOnEdt(() -> driver.canvas().zoomIn());
        Camera zoomed = callOnEdt(() -> driver.canvas().camera());
        driver.runFast(frame -> frame.snapshot().tick() > 10);
        driver.choose("restart");
        driver.waitForFrame("the start", frame -> frame.snapshot().tick() == 0);
        assertEquals(zoomed, callOnEdt(() -> driver.canvas().camera()));
        Path sameSize = Files.copy(office, folder.resolve("other.xml"));
        runOnEdt(() -> driver.window().open(sameSize));
        driver.waitForTitle("other.xml");
        driver.robot()
                .waitFor(
                        "the world is fitted",
                        () -> fitted.equals(driver.canvas().camera()));
    }

    /** As when a damaged file is double-clicked: the program has nothing else to show. */
    @Test
    void anExampleIsOpenInPlaceOfAFirstFileThatCannotBeOpened() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.faultline"), "<scenario");
        driver.close();
        driver = WindowDriver.openEmpty();
        runOnEdt(() -> driver.window().open(bad));
        JDialog dialog = driver.dialog("Scenario not opened");
        assertTrue(
                WindowDriver.text(dialog).contains("bad.faultline cannot be opened. An example is open instead."),
                WindowDriver.text(dialog));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.waitForTitle("Office");
    }

    @Test
    void theFirstFileMayHaveTheNameOfTheExample() {
        driver.close();
        driver = WindowDriver.openEmpty();
        runOnEdt(() -> driver.window().open(Path.of("office.xml"), () -> {
            throw new IOException("damaged");
        }));
        String text = WindowDriver.text(driver.dialog("Scenario not opened"));
        assertTrue(text.contains("An example is open instead."), text);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.waitForTitle("Office");
    }

    @Test
    void aSensorThatTheTimelineSwitchesOffAtTimeZeroIsOffBeforeTheFirstTick() throws IOException {
        Path off = Files.writeString(
                folder.resolve("off.xml"),
                Files.readString(square)
                        .replaceFirst(
                                "(?s)<timeline>.*</timeline>",
                                "<timeline><switch at=\"0\" sensor=\"left\" on=\"false\"/></timeline>"));
        runOnEdt(() -> driver.window().open(off));
        driver.waitForTitle("off.xml");
        JCheckBox left = ComponentFinder.find(driver.window(), JCheckBox.class, "Switch left on or off");
        driver.robot().waitFor("the switch is off", () -> !left.isSelected());
        assertEquals(0, driver.frame().snapshot().tick());
    }

    /**
     * Drags files to a component, and returns what the program is asked to do with its own, an action of DnDConstants.
     */
    private Object drop(Component target, Path... files) {
        JFrame source = callOnEdt(() -> DragSourceWindow.create(files));
        driver.robot().open(source);
        try {
            JLabel label = callOnEdt(() ->
                    ComponentFinder.findAll(source, JLabel.class).findFirst().orElseThrow());
            driver.robot().moveTo(label, 20, 20);
            driver.robot().whilePressing(InputEvent.BUTTON1_DOWN_MASK, () -> {
                driver.robot().moveSmoothly(label, 20, 20, 60, 30);
                driver.robot().moveSmoothly(target, 5, 5, target.getWidth() / 2.0, target.getHeight() / 2.0);
                driver.robot().waitForPaint();
            });
            driver.robot().waitFor("the drag has ended", () -> dropAction(source) != null);
            return callOnEdt(() -> dropAction(source));
        } finally {
            driver.robot().close(source);
        }
    }

    private static Object dropAction(JFrame source) {
        return source.getRootPane().getClientProperty(DragSourceWindow.DROP_ACTION);
    }

    @ParameterizedTest
    @ValueSource(classes = {JScrollPane.class, JTextField.class})
    void aFileDroppedOnTheGalleryOpensAndClosesIt(Class<? extends Component> target) {
        driver.chooseLater("examples");
        JDialog gallery = driver.dialog(Messages.get("gallery.title"));
        drop(ComponentFinder.findAll(gallery, target).findFirst().orElseThrow(), square);
        driver.waitForTitle("square.xml");
        assertFalse(callOnEdt(gallery::isShowing), "the gallery is open");
    }

    @Test
    void theFirstOfSomeDroppedFilesOpensAndANoteCountsTheOthers() {
        Object action = drop(driver.canvas(), square, office, office);
        driver.waitForTitle("square.xml");
        String note = Messages.get("note.firstOpened", "square.xml", "2");
        driver.robot().waitFor("the note", () -> ComponentFinder.findAll(driver.window(), JLabel.class)
                .anyMatch(shown -> note.equals(shown.getText())));
        assertEquals(DnDConstants.ACTION_COPY, action, "a program deletes files that have been moved");
    }

    @Test
    void aFileThatIsDroppedOnAFieldOpens() {
        JTextField id = ComponentFinder.find(driver.window(), JTextField.class, "Id");
        drop(id, square);
        driver.waitForTitle("square.xml");
        drop(ComponentFinder.find(driver.window(), JTextField.class, "Range of front, metres"), office);
        driver.waitForTitle("office.xml");
        assertEquals("front", callOnEdt(id::getText));
    }

    @Test
    void withUnsavedChangesOpeningAsksAndCancelStays() {
        edit();
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_O);
        choose("Examples");
        driver.clickButton("Unsaved changes", "Cancel");
        assertEquals("office.xml* – Faultline", callOnEdt(driver.window()::getTitle));
    }

    @Test
    void withUnsavedChangesOpeningDiscardsThemOnRequest() throws ScenarioException {
        Scenario before = Scenario.load(office);
        edit();
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_O);
        driver.clickButton("Unsaved changes", "Don't save");
        driver.enterFile("Open scenario", square);
        driver.waitForTitle("square.xml");
        assertEquals(before, Scenario.load(office));
    }

    @Test
    void withUnsavedChangesOpeningSavesThemFirstOnRequest() throws ScenarioException {
        Scenario before = Scenario.load(office);
        edit();
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_O);
        driver.clickButton("Unsaved changes", "Save");
        driver.enterFile("Open scenario", square);
        driver.waitForTitle("square.xml");
        assertNotEquals(before, Scenario.load(office));
    }

    @Test
    void anExampleIsChosenByTheKeyboard() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_O);
        JDialog gallery = driver.dialog("Examples");
        JList<?> list =
                ComponentFinder.findAll(gallery, JList.class).findFirst().orElseThrow();
        driver.robot().waitFor("two examples are there", () -> list.getModel().getSize() >= 2);
        runOnEdt(list::requestFocusInWindow);
        driver.robot().waitFor("the list has the focus", list::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_RIGHT);
        driver.robot().waitFor("the second is chosen", () -> list.getSelectedIndex() == 1);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the gallery is gone", () -> !gallery.isShowing());
        driver.robot().waitFor("another scenario is open", () -> !driver.window()
                .getTitle()
                .startsWith("office.xml"));
    }

    @Test
    void lettersTypedInTheListOfExamplesSearch() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_O);
        JDialog gallery = driver.dialog("Examples");
        JList<?> list =
                ComponentFinder.findAll(gallery, JList.class).findFirst().orElseThrow();
        driver.robot().waitFor("ten examples are there", () -> list.getModel().getSize() >= 10);
        driver.robot().waitFor("the list has the focus", list::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_Y);
        driver.robot().pressKeys(KeyEvent.VK_A);
        driver.robot().pressKeys(KeyEvent.VK_R);
        driver.robot().pressKeys(KeyEvent.VK_D);
        JTextField search = ComponentFinder.find(gallery, JTextField.class, "Search");
        driver.robot().waitFor("the search", () -> search.getText().equals("yard"));
        driver.robot()
                .waitFor(
                        "the yard",
                        () -> list.getModel().getSize() >= 1 && list.getModel().getSize() < 10);
        driver.robot().pressKeys(KeyEvent.VK_DOWN);
        driver.robot().waitFor("the list has the focus again", list::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
    }

    @Test
    void aSearchWithoutResultsSaysSo() {
        driver.chooseLater("examples");
        JDialog gallery = driver.dialog("Examples");
        JList<?> list =
                ComponentFinder.findAll(gallery, JList.class).findFirst().orElseThrow();
        driver.robot().waitFor("an example is there", () -> list.getModel().getSize() > 0);
        JTextArea description = ComponentFinder.find(gallery, JTextArea.class, Messages.get("gallery.description"));
        JTextField search = ComponentFinder.find(gallery, JTextField.class, "Search");
        runOnEdt(() -> search.setText("nowhere"));
        assertEquals("No example matches. Change the search or the group.", callOnEdt(description::getText));
        runOnEdt(() -> search.setText(""));
        driver.robot().waitFor("its description", () -> description.getText().startsWith("An office"));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
    }

    @Test
    void onlyADoubleClickWithTheLeftButtonOnAnExampleOpensIt() {
        driver.chooseLater("examples");
        JDialog gallery = driver.dialog("Examples");
        JList<?> list =
                ComponentFinder.findAll(gallery, JList.class).findFirst().orElseThrow();
        driver.robot().waitFor("ten examples are there", () -> list.getModel().getSize() >= 10);
        JTextField search = ComponentFinder.find(gallery, JTextField.class, "Search");
        runOnEdt(() -> search.setText("yard"));
        driver.robot().waitFor("the yard is the only one", () -> list.getModel().getSize() == 1);
        driver.robot().doubleClick(list, 20, list.getHeight() - 20);
        assertTrue(callOnEdt(gallery::isShowing), "a double click beside the example opened it");
        driver.robot().click(list, 20, 20, InputEvent.BUTTON3_DOWN_MASK);
        driver.robot().click(list, 20, 20, InputEvent.BUTTON3_DOWN_MASK);
        assertTrue(callOnEdt(gallery::isShowing), "a double click with the right button opened the example");
        driver.robot().doubleClick(list, 20, 20);
        driver.robot().waitFor("the gallery is gone", () -> !gallery.isShowing());
    }

    @Test
    void theHeadingOfANarrowGalleryIsNotCut() {
        driver.chooseLater("examples");
        JDialog gallery = driver.dialog("Examples");
        runOnEdt(() -> {
            gallery.setMinimumSize(null);
            gallery.setSize(420, 500);
        });
        JTextArea heading = ComponentFinder.findAll(gallery, JTextArea.class)
                .filter(text -> text.getText().equals(Messages.get("gallery.heading")))
                .findFirst()
                .orElseThrow();
        int line = callOnEdt(() -> heading.getFontMetrics(heading.getFont()).getHeight());
        driver.robot()
                .waitFor("a heading of two lines", () -> heading.getWidth() < 420 && heading.getHeight() >= 2 * line);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the gallery is gone", () -> !gallery.isShowing());
    }

    @Test
    void aClickBesideTheGalleryLeavesTheKeysToIt() {
        driver.chooseLater("examples");
        JDialog gallery = driver.dialog("Examples");
        driver.robot().click(driver.canvas(), 10, 10, InputEvent.BUTTON1_DOWN_MASK);
        runOnEdt(driver.window()::toFront);
        driver.robot().waitForPaint();
        driver.robot().pressKeys(KeyEvent.VK_SPACE);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the gallery is gone", () -> !gallery.isShowing());
        assertFalse(callOnEdt(driver::isRunning), "the run behind the gallery is running");
    }

    @Test
    void theGuideComesToTheFrontIfItIsOpen() {
        driver.choose("guide");
        JDialog open = driver.dialog("User guide");
        runOnEdt(driver.window()::requestFocus);
        driver.robot().waitFor("the window has the focus", driver.window()::isFocused);
        driver.choose("guide");
        driver.robot().waitFor("the dialog has the focus", open::isFocused);
        assertEquals(1, callOnEdt(() -> Stream.of(driver.window().getOwnedWindows())
                .filter(Window::isShowing)
                .count()));
    }

    private void choose(String gallery) {
        JDialog dialog = driver.dialog(gallery);
        JList<?> list = ComponentFinder.findAll(dialog, JList.class).findFirst().orElseThrow();
        driver.robot().waitFor("an example is chosen", () -> list.getSelectedIndex() == 0);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
    }

    private void edit() {
        driver.drag(0, 0, 30);
        driver.waitForTitle("office.xml*");
    }
}
