package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.JavaProcess;
import faultline.engine.Frame;
import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import javax.swing.JSlider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** A run changed by mouse and keys in a real window, saved as a journal, and replayed without the window and in it. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class JournalRobotTest {

    private static final int LEFT = InputEvent.BUTTON1_DOWN_MASK;
    private static final int RIGHT = InputEvent.BUTTON3_DOWN_MASK;

    @TempDir
    private Path folder;

    private Path journal;
    private WindowDriver driver;

    @BeforeEach
    void open() {
        journal = folder.resolve("session.xml");
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void anInteractiveSessionRunsHeadlessAndReplaysInTheWindowWithTheSameHash() throws IOException {
        driver.type(KeyEvent.VK_SPACE);
        driver.waitForFrame("time runs", frame -> frame.snapshot().time() > 0.2);
        setRangeAndCone();
        toggleAllSensors();
        moveTheDeskIntoTheRobotsPath();
        drawATriangle();
        undoAndRedoTenTimes();
        driver.waitForFrame("some more of the run", after(driver.frame(), 1));
        Frame last = pause();
        driver.chooseLater("saveJournal");
        driver.enterFile("Save journal", journal);
        driver.robot().waitFor("the journal is there", () -> Files.exists(journal));
        assertEquals(hash(last), headless(journal));
        runOnEdt(() -> driver.window().open(journal));
        driver.waitForTitle("session.xml (replay)");
        driver.waitForFrame("it is at its beginning", frame -> frame.snapshot().tick() == 0);
        driver.robot().waitFor("the window says so", () -> driver.statusNote().startsWith("Saved run"));
        for (int i = 0; i < 12; i++) {
            driver.choose("faster");
        }
        driver.choose("run");
        driver.waitForFrame(
                "the replay is at its end",
                frame -> frame.snapshot().tick() == last.snapshot().tick());
        driver.robot()
                .waitFor(
                        "it holds there, and says so",
                        () -> !driver.isRunning() && driver.statusNote().startsWith("Replay finished"));
        assertEquals(hash(last), hash(driver.frame()));
        assertEquals(last.snapshot().obstacles(), driver.frame().snapshot().obstacles());
        assertEquals(sensors(last), sensors(driver.frame()));
        driver.choose("run");
        driver.waitForFrame(
                "it continues if the user says so",
                frame -> frame.snapshot().tick() > last.snapshot().tick());
    }

    private void setRangeAndCone() {
        driver.typeInto("Range of left, metres", KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_9, KeyEvent.VK_ENTER);
        driver.waitForFrame("the range is 0.9 m", frame -> left(frame).range() == 0.9);
        driver.typeInto("Cone of left, degrees", KeyEvent.VK_3, KeyEvent.VK_0, KeyEvent.VK_ENTER);
        driver.waitForFrame("the cone is 30 degrees", frame -> left(frame).cone() == Degrees.toRadians(30));
        runOnEdt(() -> driver.canvas().requestFocusInWindow());
        driver.robot().waitFor("the canvas has the focus", driver.canvas()::isFocusOwner);
    }

    private static SensorSpec left(Frame frame) {
        return frame.snapshot().robot().sensor("left").orElseThrow();
    }

    private void toggleAllSensors() {
        for (int key = KeyEvent.VK_1; key <= KeyEvent.VK_8; key++) {
            List<Boolean> before = switches(driver.frame());
            driver.robot().pressKeys(key);
            driver.waitForFrame(
                    "a sensor is switched", frame -> !switches(frame).equals(before));
        }
    }

    private static List<Boolean> switches(Frame frame) {
        return frame.snapshot().robot().sensors().stream().map(SensorSpec::on).toList();
    }

    private static List<SensorSpec> sensors(Frame frame) {
        return frame.snapshot().robot().sensors();
    }

    private void moveTheDeskIntoTheRobotsPath() {
        driver.drag(0, -30, -20);
        Obstacle desk = driver.frame().snapshot().obstacles().get(0);
        Vector2 at = onScreen(desk.pose().position());
        driver.robot().drag(driver.canvas(), at.x() + 6, at.y() + 6, at.x() + 14, at.y() - 24, RIGHT);
        driver.waitForFrame(
                "the desk is turned",
                frame -> frame.snapshot().obstacles().get(0).pose().heading()
                        != desk.pose().heading());
    }

    private void drawATriangle() {
        driver.choose("drawPolygon");
        click(6, 1.5);
        click(7, 1.5);
        click(6.5, 2.2);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForFrame("the triangle is there", frame -> frame.snapshot().obstacles().stream()
                .anyMatch(obstacle -> obstacle.id().equals("polygon")));
    }

    private void click(double x, double y) {
        Vector2 at = onScreen(new Vector2(x, y));
        driver.robot().click(driver.canvas(), at.x(), at.y(), LEFT);
    }

    private Vector2 onScreen(Vector2 world) {
        return callOnEdt(() -> driver.canvas().camera().toScreen(world));
    }

    private void undoAndRedoTenTimes() {
        List<Obstacle> obstacles = driver.frame().snapshot().obstacles();
        List<SensorSpec> sensors = sensors(driver.frame());
        for (int i = 0; i < 10; i++) {
            driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        }
        driver.waitForFrame(
                "ten edits are undone",
                frame -> switches(frame).contains(true)
                        && frame.snapshot().obstacles().size() < obstacles.size());
        for (int i = 0; i < 10; i++) {
            driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Y);
        }
        driver.waitForFrame(
                "ten edits are redone",
                frame -> frame.snapshot().obstacles().size() == obstacles.size()
                        && sensors(frame).equals(sensors));
    }

    @Test
    void seekingIntoThePastKeepsLaterEditsRedoable() {
        driver.type(KeyEvent.VK_SPACE);
        driver.waitForFrame("time runs", frame -> frame.snapshot().time() > 0.5);
        Obstacle before = driver.frame().snapshot().obstacles().get(0);
        driver.drag(0, -30, -20);
        Obstacle moved = driver.frame().snapshot().obstacles().get(0);
        driver.waitForFrame("some more of the run", after(driver.frame(), 0.5));
        pause();
        scrubToTheBeginning();
        driver.waitForFrame(
                "the desk is where it was",
                frame -> frame.snapshot().obstacles().get(0).equals(before));
        driver.waitForTitle("office.xml*");
        driver.robot().pressKeys(KeyEvent.VK_1);
        driver.waitForFrame(
                "a sensor is switched off", frame -> !sensors(frame).get(0).on());
        driver.robot().waitFor("the window says what becomes of the later edit", () -> driver.statusNote()
                .endsWith("under Redo: 1"));
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Y);
        driver.waitForFrame(
                "the desk is moved again",
                frame -> frame.snapshot().obstacles().get(0).equals(moved));
    }

    private void scrubToTheBeginning() {
        JSlider slider = ComponentFinder.find(driver.window(), JSlider.class, "Time line");
        runOnEdt(slider::requestFocusInWindow);
        driver.robot().waitFor("the line has the focus", slider::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_HOME);
        driver.waitForFrame(
                "time is at its beginning", frame -> frame.snapshot().tick() == 0);
        runOnEdt(() -> driver.canvas().requestFocusInWindow());
        driver.robot().waitFor("the canvas has the focus", driver.canvas()::isFocusOwner);
    }

    private Frame pause() {
        driver.type(KeyEvent.VK_SPACE);
        driver.robot().waitFor("time is held", () -> !driver.isRunning());
        driver.robot().waitForPaint();
        return driver.frame();
    }

    private static Predicate<Frame> after(Frame earlier, double seconds) {
        return frame -> frame.snapshot().time() > earlier.snapshot().time() + seconds;
    }

    private static String hash(Frame frame) {
        return String.format(Locale.ROOT, "%016x", frame.trajectoryHash());
    }

    /** Returns the hash that the program prints for a file when it runs without a window. */
    private static String headless(Path file) throws IOException {
        List<String> command = JavaProcess.program();
        command.addAll(List.of("run", file.toString()));
        Process program = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try (BufferedReader lines = program.inputReader(StandardCharsets.UTF_8)) {
            return lines.lines()
                    .filter(line -> line.startsWith("trajectory_hash: "))
                    .toList()
                    .get(0)
                    .substring("trajectory_hash: ".length());
        }
    }
}
