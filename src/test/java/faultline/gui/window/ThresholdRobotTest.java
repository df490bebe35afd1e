package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Threshold;
import faultline.engine.Frame;
import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.panel.ControllerPanel;
import faultline.gui.theme.FlatSliderUI;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioRun;
import faultline.scenario.xml.ScenarioException;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JSlider;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** A threshold of the wall follower is typed into the Controller tab of a real window. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ThresholdRobotTest {

    private static final String FIELD = "Wall ahead, m";

    @TempDir
    private Path folder;

    private Path file;
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        openFile();
    }

    private void openFile() {
        driver = WindowDriver.open(Theme.LIGHT, file);
        JTabbedPane tabs = ComponentFinder.findAll(driver.window(), JTabbedPane.class)
                .filter(pane -> ComponentFinder.findAll(pane, ControllerPanel.class)
                        .findAny()
                        .isPresent())
                .findFirst()
                .orElseThrow();
        Rectangle tab = callOnEdt(() -> tabs.getBoundsAt(1));
        driver.robot().click(tabs, tab.getCenterX(), tab.getCenterY(), InputEvent.BUTTON1_DOWN_MASK);
        driver.robot().waitFor("the field shows", () -> field().isShowing());
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private JTextField field() {
        return ComponentFinder.find(driver.window(), JTextField.class, FIELD);
    }

    private void waitForField(String text) {
        driver.robot()
                .waitFor("the field shows " + text, () -> field().getText().equals(text));
    }

    private void typeHalfAMetre() {
        driver.typeInto(FIELD, KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_5, KeyEvent.VK_ENTER);
        driver.waitForTitle("office.xml*");
    }

    /** Runs until the robot has aligned itself, and returns the visible frame; the run continues. */
    private Frame runUntilAligned() {
        driver.runFast(frame -> frame.telemetry().transitions() >= 4);
        return driver.frame();
    }

    private static Pose pose(Scenario scenario, Frame frame) {
        ScenarioRun run = scenario.withSetup(scenario.setup()
                        .withDuration(scenario.setup().timeOf(frame.snapshot().tick() + 1)))
                .run();
        return run.poseAt(scenario.setup().timeOf(frame.snapshot().tick()));
    }

    private static double threshold(Scenario scenario) {
        return ((WallFollowing) scenario.setup().controller()).thresholds().get(Threshold.AHEAD_MARGIN);
    }

    @Test
    void aTypedThresholdActsIsUndoneRedoneSavedAndThereAgain() throws ScenarioException {
        Scenario original = Scenario.load(file);
        WallFollowing follower = (WallFollowing) original.setup().controller();
        Scenario changed = original.withSetup(
                original.setup().withController(follower.withThreshold(Threshold.AHEAD_MARGIN, 0.5)));
        typeHalfAMetre();
        Frame frame = runUntilAligned();
        assertEquals(pose(changed, frame), frame.snapshot().pose());
        assertNotEquals(pose(original, frame), frame.snapshot().pose());
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForTitle("office.xml");
        waitForField("0.00");
        driver.choose("redo");
        driver.waitForTitle("office.xml*");
        waitForField("0.50");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        assertEquals(0.5, threshold(Scenario.load(file)));
        driver.close();
        openFile();
        waitForField("0.50");
        Frame again = runUntilAligned();
        assertEquals(pose(changed, again), again.snapshot().pose());
    }

    @Test
    void theReferenceRunShowsWhatAChangeDid() {
        runUntilAligned();
        driver.choose("keepGhost");
        driver.waitForReferenceRun();
        driver.choose("restart");
        driver.waitForFrame(
                "the run is at its start again", frame -> frame.snapshot().tick() == 0);
        typeHalfAMetre();
        if (!driver.isRunning()) {
            driver.choose("run");
        }
        driver.robot().waitFor("the first difference is marked", () -> mark() != null);
    }

    private Object mark() {
        return ComponentFinder.find(driver.window(), JSlider.class, "Time line")
                .getClientProperty(FlatSliderUI.MARK_PROPERTY);
    }
}
