package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.SensorSpec;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Saving, reverting and closing in a real window, after an obstacle was dragged. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class SaveRobotTest {

    private static final int OBSTACLES_TAB = 3;

    @TempDir
    private Path folder;

    private Path file;
    private WindowDriver driver;
    private Pose before;
    private Pose after;

    @BeforeEach
    void openAndDrag() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        driver = WindowDriver.open(Theme.LIGHT, file);
        before = shown();
        driver.drag(0, 0, 30);
        driver.waitForTitle("office.xml*");
        after = shown();
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private Pose shown() {
        return driver.frame().snapshot().obstacles().get(0).pose();
    }

    private static Pose saved(Path where) throws ScenarioException {
        return Scenario.load(where).setup().world().obstacles().get(0).pose();
    }

    @Test
    void aNumberThatIsStillBeingTypedIsSaved() throws ScenarioException {
        driver.typeInto("Linear velocity", KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_4, KeyEvent.VK_1);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        assertEquals(0.41, Scenario.load(file).setup().robot().speed());
    }

    /** An open menu has the focus for a time. */
    @Test
    void aNumberThatIsStillBeingTypedIsSavedByTheMenu() throws ScenarioException {
        driver.typeInto("Linear velocity", KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_4, KeyEvent.VK_1);
        JMenu menu = callOnEdt(() -> driver.window().getJMenuBar().getMenu(0));
        driver.click(menu);
        driver.robot().waitFor("the menu", menu::isPopupMenuVisible);
        JMenuItem save = callOnEdt(() -> IntStream.range(0, menu.getItemCount())
                .mapToObj(menu::getItem)
                .filter(item -> item != null && item.getText().equals("Save"))
                .findFirst()
                .orElseThrow());
        driver.click(save);
        driver.waitForTitle("office.xml");
        assertEquals(0.41, Scenario.load(file).setup().robot().speed());
    }

    @Test
    void aNumberThatIsStillBeingTypedIsNotLostWithoutAQuestion() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        driver.typeInto("Linear velocity", KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_4, KeyEvent.VK_1);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        driver.clickButton("Unsaved changes", "Cancel");
        driver.waitForTitle("office.xml*");
        // The run is simulated again with the new speed.
        driver.waitForFrame("the speed", frame -> frame.snapshot().robot().speed() == 0.41);
    }

    @Test
    void waypointsThatAreStillBeingTypedAreNotLostWithoutAQuestion() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        JTextField waypoints = callOnEdt(() -> {
            ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel")
                    .setSelectedIndex(OBSTACLES_TAB);
            return ComponentFinder.find(driver.window(), JTextField.class, "Waypoints, m");
        });
        driver.robot().waitFor("the form shows the selected obstacle", waypoints::isEnabled);
        driver.typeInto("Waypoints, m", KeyEvent.VK_1, KeyEvent.VK_COMMA, KeyEvent.VK_2);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        driver.clickButton("Unsaved changes", "Cancel");
        driver.waitForTitle("office.xml*");
        List<Vector2> typed = List.of(new Vector2(1, 2));
        driver.waitForFrame(
                "the waypoints",
                frame ->
                        frame.snapshot().obstacles().get(0).motion().waypoints().equals(typed));
    }

    @Test
    void aChangeByAnotherProgramIsNotOverwrittenWithoutAQuestion() throws IOException, ScenarioException {
        Files.writeString(file, Files.readString(file).replaceFirst("name=\"Office\"", "name=\"Other\""));
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.dialog("File changed");
        assertEquals(before, saved(file));
        driver.clickButton("File changed", "Keep my version");
        driver.waitForTitle("office.xml");
        assertEquals(after, saved(file));
    }

    @Test
    void saveAsWritesANewFileAndLeavesTheOldOneUnchanged() throws ScenarioException {
        Path other = folder.resolve("other.xml");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);
        driver.enterFile("Save scenario", other);
        driver.waitForTitle("other.xml");
        assertEquals(after, saved(other));
        assertEquals(before, saved(file));
    }

    @Test
    void aNameThatLooksLikeAPatternIsSavedAsItIs() throws ScenarioException {
        Path other = folder.resolve("room [2].xml");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);
        driver.enterFile("Save scenario", other);
        driver.waitForTitle("room [2].xml");
        assertEquals(after, saved(other));
    }

    @Test
    void saveAsAndExportsKeepTheNameOfAFileThatADesktopOpens() throws IOException {
        Path room = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("room.faultline"));
        runOnEdt(() -> driver.window().open(room));
        driver.waitForTitle("room.faultline");
        driver.chooseLater("saveAs");
        assertEquals(room.toString(), suggestedFile("Save scenario"));
        driver.chooseLater("exportSvg");
        assertEquals(folder.resolve("room.svg").toString(), suggestedFile("Export drawing"));
    }

    /** Returns the file that a chooser suggests and cancels it. */
    private String suggestedFile(String title) {
        JDialog dialog = driver.dialog(title);
        JFileChooser chooser =
                ComponentFinder.findAll(dialog, JFileChooser.class).findFirst().orElseThrow();
        String file = callOnEdt(() -> chooser.getSelectedFile().toString());
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the chooser is gone", () -> !dialog.isShowing());
        return file;
    }

    @Test
    void saveAsAsksBeforeItReplacesAFile() throws IOException {
        Path other = Files.writeString(folder.resolve("other.xml"), "precious");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);
        JDialog chooser = driver.typeFile("Save scenario", folder.resolve("other"));
        driver.clickButton("Replace file", "Cancel");
        assertEquals("precious", Files.readString(other));
        assertTrue(chooser.isShowing(), "another name can be entered");
        driver.typeFile("Save scenario", other);
        driver.clickButton("Replace file", "Replace");
        driver.waitForTitle("other.xml");
        assertFalse(chooser.isShowing());
        assertTrue(Files.readString(other).contains("<scenario"));
    }

    @Test
    void aFolderIsNotOfferedForReplacementAndAMissingOneIsNamed() throws IOException {
        Files.createDirectory(folder.resolve("drawing.svg"));
        driver.chooseLater("exportSvg");
        driver.typeFile("Export drawing", folder.resolve("drawing"));
        confirm("Export drawing", "drawing.svg is a folder. Enter another name.");
        driver.typeFile("Export drawing", folder.resolve("missing/a.svg"));
        confirm("Export drawing", folder.resolve("missing") + " does not exist.");
        Path other = folder.resolve("other.svg");
        driver.enterFile("Export drawing", other);
        driver.robot().waitFor("the drawing is written", () -> Files.exists(other));
    }

    /** Waits for a message in front of a chooser and closes it. */
    private void confirm(String title, String sentence) {
        driver.robot()
                .waitFor("it says: " + sentence, () -> messages(title).findAny().isPresent());
        String text =
                WindowDriver.text(callOnEdt(() -> messages(title).findAny().orElseThrow()));
        assertTrue(text.replaceAll("\\s+", " ").contains(sentence), text);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot()
                .waitFor("the message is gone", () -> messages(title).findAny().isEmpty());
    }

    private static Stream<JDialog> messages(String title) {
        return Stream.of(Window.getWindows())
                .filter(window -> window instanceof JDialog && window.isFocused())
                .map(JDialog.class::cast)
                .filter(dialog -> title.equals(dialog.getTitle())
                        && ComponentFinder.findAll(dialog, JFileChooser.class)
                                .findAny()
                                .isEmpty());
    }

    @Test
    void aFailedSaveIsReportedAndLosesNothing() throws IOException, ScenarioException {
        Files.delete(file);
        Files.createDirectory(file);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        JDialog dialog = driver.dialog("Faultline");
        assertTrue(
                WindowDriver.text(dialog).contains("office.xml cannot be saved: this is a folder; expected a file"),
                WindowDriver.text(dialog));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertEquals("office.xml* – Faultline", callOnEdt(driver.window()::getTitle));
        assertEquals(after, shown());
        Files.delete(file);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        assertEquals(after, saved(file));
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void anExportThatIsTheOpenScenarioByALinkIsRefused(boolean hard) throws IOException {
        byte[] original = Files.readAllBytes(file);
        Path link = folder.resolve("drawing.svg");
        if (hard) {
            Files.createLink(link, file);
        } else {
            Files.createSymbolicLink(link, file);
        }
        driver.chooseLater("exportSvg");
        driver.typeFile("Export drawing", link);
        driver.clickButton("Replace file", "Replace");
        JDialog dialog = driver.dialog("Faultline");
        assertTrue(
                WindowDriver.text(dialog).contains("this is the open scenario itself; expected another file"),
                WindowDriver.text(dialog));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertArrayEquals(original, Files.readAllBytes(file));
    }

    @Test
    void revertAsksAndDiscardsTheChanges() throws IOException {
        byte[] original = Files.readAllBytes(file);
        driver.chooseLater("revert");
        driver.clickButton("Revert", "Cancel");
        assertEquals(after, shown());
        driver.chooseLater("revert");
        driver.clickButton("Revert", "Revert");
        driver.waitForTitle("office.xml");
        driver.waitForFrame(
                "all is as it was",
                frame -> frame.snapshot().obstacles().get(0).pose().equals(before));
        assertArrayEquals(original, Files.readAllBytes(file));
    }

    @Test
    void revertDiscardsTheNumberThatIsBeingTyped() throws ScenarioException {
        SensorSpec front = Scenario.load(file).setup().robot().sensors().get(0);
        String name = "Noise of the selected sensor, standard deviation in metres";
        JTextField noise = ComponentFinder.find(driver.window(), JTextField.class, name);
        String shown = callOnEdt(noise::getText);
        driver.typeInto(name, KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_0, KeyEvent.VK_5);
        driver.chooseLater("revert");
        driver.clickButton("Revert", "Revert");
        driver.waitForFrame(
                "all is as it was",
                frame -> frame.snapshot().obstacles().get(0).pose().equals(before));
        driver.waitForTitle("office.xml");
        assertEquals(shown, callOnEdt(noise::getText));
        assertEquals(front, driver.frame().snapshot().robot().sensors().get(0));
        assertFalse(callOnEdt(() -> driver.isEnabled("undo")));
    }

    @Test
    void enterGivesTheFocusedAnswer() throws IOException {
        byte[] original = Files.readAllBytes(file);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        driver.dialog("Unsaved changes");
        waitForFocus("Save");
        driver.robot().pressKeys(KeyEvent.VK_TAB);
        waitForFocus("Don't save");
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the window is closed", () -> !driver.window().isShowing());
        assertArrayEquals(original, Files.readAllBytes(file));
    }

    private void waitForFocus(String button) {
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        driver.robot()
                .waitFor(
                        button + " has the focus",
                        () -> manager.getFocusOwner() instanceof JButton focused
                                && focused.getText().equals(button));
    }

    @Test
    void closingSavesOnRequest() throws ScenarioException {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        driver.clickButton("Unsaved changes", "Save");
        driver.robot().waitFor("the window is closed", () -> !driver.window().isShowing());
        assertEquals(after, saved(file));
    }

    /** The window can be used while the file is written; its title changes when it has been. */
    @Test
    void closingAsksAboutARecordingThatIsBegunDuringTheSave() throws ScenarioException {
        runOnEdt(() -> driver.window().addPropertyChangeListener("title", event -> driver.chooseOnEdt("record")));
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        driver.clickButton("Unsaved changes", "Save");
        driver.clickButton("Recording", "Discard");
        driver.robot().waitFor("the window is closed", () -> !driver.window().isShowing());
        assertEquals(after, saved(file));
    }

    @Test
    void theCloseButtonOfTheWindowAsksTooAndEscCancels() throws ScenarioException {
        EventQueue.invokeLater(
                () -> driver.window().dispatchEvent(new WindowEvent(driver.window(), WindowEvent.WINDOW_CLOSING)));
        JDialog dialog = driver.dialog("Unsaved changes");
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertTrue(callOnEdt(driver.window()::isShowing));
        assertEquals(before, saved(file));
    }

    @Test
    void undoingAllEditsLeavesNoUnsavedChanges() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForTitle("office.xml");
        driver.waitForFrame(
                "the obstacle is where it was",
                frame -> frame.snapshot().obstacles().get(0).pose().equals(before));
    }
}
