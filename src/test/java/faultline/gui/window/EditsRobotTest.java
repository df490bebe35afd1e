package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.EventQueue;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.JCheckBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** Edits of all kinds in a real window, undone and redone. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class EditsRobotTest {

    private static final int LEFT = InputEvent.BUTTON1_DOWN_MASK;
    private static final int RIGHT = InputEvent.BUTTON3_DOWN_MASK;

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    /** Everything that the ten edits change. */
    private record State(List<Obstacle> obstacles, List<SensorSpec> sensors) {
        static State of(Frame frame) {
            return new State(
                    frame.snapshot().obstacles(), frame.snapshot().robot().sensors());
        }
    }

    private State state() {
        return State.of(driver.frame());
    }

    private boolean isMarkedChanged() {
        return driver.window().getTitle().contains("*");
    }

    private Vector2 onScreen(Vector2 world) {
        return callOnEdt(() -> driver.canvas().camera().toScreen(world));
    }

    private Vector2 middleOfDesk() {
        return onScreen(driver.frame().snapshot().obstacles().get(0).pose().position());
    }

    private void drag(Vector2 by, int button) {
        State before = state();
        Vector2 from = middleOfDesk().plus(new Vector2(6, 6));
        driver.robot().drag(driver.canvas(), from.x(), from.y(), from.x() + by.x(), from.y() + by.y(), button);
        driver.waitForFrame(
                "the obstacle is elsewhere", frame -> !State.of(frame).equals(before));
    }

    @Test
    void tenEditsAreUndoneAndRedoneByKeys() {
        State first = state();
        drag(new Vector2(-30, -20), LEFT);
        drag(new Vector2(8, -30), RIGHT);
        for (int key = KeyEvent.VK_1; key <= KeyEvent.VK_8; key++) {
            State before = state();
            driver.robot().pressKeys(key);
            driver.waitForFrame(
                    "a sensor is switched", frame -> !State.of(frame).equals(before));
        }
        State last = state();
        driver.robot().waitFor("the window says that there are changes", this::isMarkedChanged);
        pressRepeatedly(10, KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame("all is as it was", frame -> State.of(frame).equals(first));
        driver.robot().waitFor("the window says that nothing is changed", () -> !isMarkedChanged());
        pressRepeatedly(5, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        pressRepeatedly(5, KeyEvent.VK_CONTROL, KeyEvent.VK_Y);
        driver.waitForFrame("all is as it had become", frame -> State.of(frame).equals(last));
        assertEquals(last, state());
    }

    @Test
    void undoFirstTakesBackWhatIsTypedInAField() {
        State first = state();
        typeAndUndo();
        assertEquals(first, state());
        driver.click(ComponentFinder.find(driver.window(), JCheckBox.class, "Switch left on or off"));
        driver.waitForFrame("a sensor is switched", frame -> !State.of(frame).equals(first));
        State switched = state();
        typeAndUndo();
        assertEquals(switched, state());
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame("the sensor is on again", frame -> State.of(frame).equals(first));
    }

    private void typeAndUndo() {
        JTextField range = ComponentFinder.find(driver.window(), JTextField.class, "Range of left, metres");
        String text = callOnEdt(range::getText);
        driver.typeInto("Range of left, metres", KeyEvent.VK_5);
        driver.robot().waitFor("the digit", () -> range.getText().equals("5"));
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.robot().waitFor("the text before", () -> range.getText().equals(text));
    }

    private void pressRepeatedly(int times, int... keys) {
        for (int i = 0; i < times; i++) {
            driver.robot().pressKeys(keys);
        }
    }

    private Vector2 point(double x, double y) {
        return onScreen(new Vector2(x, y));
    }

    private void click(double x, double y) {
        Vector2 at = point(x, y);
        driver.robot().click(driver.canvas(), at.x(), at.y(), LEFT);
    }

    /** The dialog gets the release of the button. */
    @Test
    void aDragEndsWhenADialogOpens() {
        Vector2 from = middleOfDesk().plus(new Vector2(6, 6));
        driver.robot().moveTo(driver.canvas(), from.x(), from.y());
        driver.robot().whilePressing(LEFT, () -> {
            driver.robot().moveSmoothly(driver.canvas(), from.x(), from.y(), from.x() - 30, from.y() - 20);
            EventQueue.invokeLater(() -> driver.chooseOnEdt("properties"));
            driver.dialog("Scenario properties");
        });
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the window has the focus", driver.window()::isFocused);
        State dragged = state();
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().pressKeys(KeyEvent.VK_1);
        driver.waitForFrame("the key is handled", frame -> !State.of(frame).equals(dragged));
        assertEquals(dragged.obstacles(), state().obstacles());
    }

    private void drag(Vector2 from, Vector2 to) {
        driver.robot().drag(driver.canvas(), from.x(), from.y(), to.x(), to.y(), LEFT);
    }

    private Optional<Obstacle> obstacle(Frame frame, String id) {
        return frame.snapshot().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst();
    }

    private void waitForObstacle(String what, String id, Predicate<Obstacle> condition) {
        driver.waitForFrame(what, frame -> obstacle(frame, id).filter(condition).isPresent());
    }

    private void waitForSelection(String... ids) {
        driver.robot().waitFor("the selection is as wanted", () -> driver.canvas().tools().selected().stream()
                .map(Obstacle::id)
                .toList()
                .equals(List.of(ids)));
    }

    @Test
    void aPolygonIsDrawnCornerByCornerAndSelected() {
        driver.choose("drawPolygon");
        driver.robot().waitFor("its button is lit", () -> ComponentFinder.find(
                        driver.window(), JToggleButton.class, "Polygon")
                .isSelected());
        click(6, 1.5);
        click(7, 1.5);
        click(6.5, 2.2);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        waitForObstacle(
                "the polygon is there",
                "polygon",
                polygon ->
                        ((ObstacleShape.PolygonShape) polygon.shape()).points().size() == 3);
        waitForSelection("polygon");
        driver.robot().waitFor("no button is lit", () -> !ComponentFinder.find(
                        driver.window(), JToggleButton.class, "Polygon")
                .isSelected());
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame(
                "the polygon is gone", frame -> obstacle(frame, "polygon").isEmpty());
    }

    @Test
    void aRectangleIsDrawnResizedDuplicatedAndDeleted() {
        driver.choose("snapGrid");
        driver.choose("placeRectangle");
        drag(point(6, 1.5), point(7, 2));
        waitForObstacle("it is as large as drawn", "rectangle", box -> box.shape()
                .equals(new ObstacleShape.RectangleShape(1, 0.5)));
        waitForSelection("rectangle");
        drag(point(7, 1.75), point(7.3, 1.75));
        waitForObstacle(
                "it is wider", "rectangle", box -> box.shape().equals(new ObstacleShape.RectangleShape(1.3, 0.5)));
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
        waitForSelection("rectangle-2");
        driver.robot().pressKeys(KeyEvent.VK_DELETE);
        driver.waitForFrame(
                "the copy is gone", frame -> obstacle(frame, "rectangle-2").isEmpty());
    }

    @Test
    void obstaclesAreCopiedToTheClipboardAsText() {
        driver.robot().whileHolding(KeyEvent.VK_SHIFT, () -> drag(point(2.9, 3.9), point(3.6, 3.1)));
        waitForSelection("chair-1");
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_C);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
        waitForObstacle("the copy is there", "chair-3", copy -> true);
    }

    @Test
    void anObstacleThatWouldOverlapTheRobotIsRefusedWithAReason() {
        driver.choose("placeCircle");
        click(2, 1.8);
        driver.robot().waitFor("the status bar says why", () -> ComponentFinder.findAll(driver.window(), JLabel.class)
                .anyMatch(label -> "circle cannot be put there: it would overlap the robot".equals(label.getText())));
        assertTrue(obstacle(driver.frame(), "circle").isEmpty());
        click(6.5, 2);
        waitForObstacle("it is put elsewhere", "circle", circle -> true);
    }

    @Test
    void anObstacleGetsAMotionPathByClicks() {
        click(4.7, 2.5);
        waitForSelection("chair-2");
        driver.choose("drawWaypoints");
        click(6.5, 2.5);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        waitForObstacle(
                "it has a way to there and back",
                "chair-2",
                chair -> chair.motion().waypoints().size() == 2);
    }

    @Test
    void theSpeedOnAMotionPathIsSetAndUndone() {
        anObstacleGetsAMotionPathByClicks();
        EventQueue.invokeLater(() -> driver.chooseOnEdt("motionSpeed"));
        JDialog dialog = driver.dialog("Speed of moving obstacles");
        JTextField field =
                ComponentFinder.findAll(dialog, JTextField.class).findFirst().orElseThrow();
        driver.robot().waitFor("the field has the focus", field::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        driver.robot().pressKeys(KeyEvent.VK_1);
        driver.clickButton("Speed of moving obstacles", "OK");
        waitForObstacle("it goes at 1 m/s", "chair-2", chair -> chair.motion().speed() == 1);
        driver.robot().waitFor("the edit has a name", () -> "Undo Speed of chair-2".equals(undo().getText()));
        driver.choose("undo");
        waitForObstacle("it goes as it did", "chair-2", chair -> chair.motion().speed() == 0.2);
    }

    @Test
    void anObstacleAtRestCannotBeStopped() {
        click(4.7, 2.5);
        waitForSelection("chair-2");
        driver.robot().waitFor("it can be deleted", () -> driver.isEnabled("delete"));
        assertFalse(driver.isEnabled("stopMoving"));
    }

    private JMenuItem undo() {
        return ComponentFinder.findAll(driver.window(), JMenuItem.class)
                .filter(item -> "undo".equals(item.getActionCommand()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void draggingTheRobotMovesTheStartPoseAndUndoRestoresIt() {
        drag(point(2, 1.8), point(2.5, 2));
        driver.waitForFrame(
                "it starts elsewhere",
                frame -> frame.snapshot().pose().position().distanceTo(new Vector2(2.5, 2)) < 0.03);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame(
                "it starts where it did",
                frame -> frame.snapshot().pose().position().equals(new Vector2(2, 1.8)));
        driver.robot().waitFor("the window says that nothing is changed", () -> !isMarkedChanged());
    }

    @Test
    void aClickSelectsAConeAndDraggingItsArcChangesTheRange() {
        Sector cone = driver.frame().snapshot().sensors().get(4).sector();
        Vector2 inside = onScreen(cone.apex().plus(cone.axis().times(cone.range() / 2)));
        driver.robot().click(driver.canvas(), inside.x(), inside.y(), LEFT);
        Vector2 rim = onScreen(cone.apex().plus(cone.axis().times(cone.range())));
        Vector2 farther = onScreen(cone.apex().plus(cone.axis().times(1.2)));
        drag(rim, farther);
        driver.waitForFrame(
                "the range is larger",
                frame -> Math.abs(frame.snapshot().sensors().get(4).spec().range() - 1.2) < 0.02);
    }

    @Test
    void presetsSwitchSensorsInOneEdit() {
        driver.choose("sensorsTwo");
        driver.waitForFrame("two are on", frame -> on(frame).equals(List.of("front", "left")));
        driver.choose("sensorsThree");
        driver.waitForFrame("three are on", frame -> on(frame).equals(List.of("front", "left", "front-right")));
        pressRepeatedly(2, KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame("all are on", frame -> on(frame).size() == 8);
    }

    private static List<String> on(Frame frame) {
        return frame.snapshot().robot().sensors().stream()
                .filter(SensorSpec::on)
                .map(SensorSpec::id)
                .toList();
    }
}
