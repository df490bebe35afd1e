package faultline.gui.window;

import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.geometry.Sector;
import faultline.geometry.Vec;
import faultline.gui.Components;
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
@DisabledIf(value = "java.awt.GraphicsEnvironment#isHeadless", disabledReason = "drives a real window, which needs a display")
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

    /** All that the ten edits change. */
    private record State(List<Obstacle> obstacles, List<SensorSpec> sensors) {
        static State of(Frame frame) {
            return new State(frame.world().obstacles(), frame.world().robot().sensors());
        }
    }

    private State state() {
        return State.of(driver.frame());
    }

    private boolean isMarkedChanged() {
        return driver.window().getTitle().contains("*");
    }

    private Vec onScreen(Vec world) {
        return onEdt(() -> driver.canvas().camera().toScreen(world));
    }

    private Vec middleOfDesk() {
        return onScreen(driver.frame().world().obstacles().get(0).pose().position());
    }

    private void drag(Vec by, int button) {
        State before = state();
        Vec from = middleOfDesk().plus(new Vec(6, 6));
        driver.robot().drag(driver.canvas(), from.x(), from.y(), from.x() + by.x(), from.y() + by.y(), button);
        driver.waitForFrame("the obstacle is elsewhere", frame -> !State.of(frame).equals(before));
    }

    @Test
    void tenEditsAreUndoneAndRedoneByKeys() {
        State first = state();
        drag(new Vec(-30, -20), LEFT);
        drag(new Vec(8, -30), RIGHT);
        for (int key = KeyEvent.VK_1; key <= KeyEvent.VK_8; key++) {
            State before = state();
            driver.robot().type(key);
            driver.waitForFrame("a sensor is switched", frame -> !State.of(frame).equals(before));
        }
        State last = state();
        driver.robot().waitFor("the window says that there are changes", this::isMarkedChanged);
        times(10, KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame("all is as it was", frame -> State.of(frame).equals(first));
        driver.robot().waitFor("the window says that nothing is changed", () -> !isMarkedChanged());
        times(5, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        times(5, KeyEvent.VK_CONTROL, KeyEvent.VK_Y);
        driver.waitForFrame("all is as it had become", frame -> State.of(frame).equals(last));
        assertEquals(last, state());
    }

    private void times(int times, int... keys) {
        for (int i = 0; i < times; i++) {
            driver.robot().type(keys);
        }
    }

    private Vec point(double x, double y) {
        return onScreen(new Vec(x, y));
    }

    private void click(double x, double y) {
        Vec at = point(x, y);
        driver.robot().click(driver.canvas(), at.x(), at.y(), LEFT);
    }

    private void drag(Vec from, Vec to) {
        driver.robot().drag(driver.canvas(), from.x(), from.y(), to.x(), to.y(), LEFT);
    }

    private Optional<Obstacle> obstacle(Frame frame, String id) {
        return frame.world().obstacles().stream().filter(obstacle -> obstacle.id().equals(id)).findFirst();
    }

    private void waitForObstacle(String what, String id, Predicate<Obstacle> condition) {
        driver.waitForFrame(what, frame -> obstacle(frame, id).filter(condition).isPresent());
    }

    private void waitForSelection(String... ids) {
        driver.robot().waitFor("the selection is as wanted",
                () -> driver.canvas().tools().selected().stream().map(Obstacle::id).toList().equals(List.of(ids)));
    }

    @Test
    void aPolygonIsDrawnCornerByCornerAndSelected() {
        driver.choose("drawPolygon");
        driver.robot().waitFor("its button is lit", () -> Components.named(driver.window(), JToggleButton.class, "Polygon").isSelected());
        click(6, 1.5);
        click(7, 1.5);
        click(6.5, 2.2);
        driver.robot().type(KeyEvent.VK_ENTER);
        waitForObstacle("the polygon is there", "polygon", polygon -> ((ObstacleShape.Polygon) polygon.shape()).points().size() == 3);
        waitForSelection("polygon");
        driver.robot().waitFor("no button is lit", () -> !Components.named(driver.window(), JToggleButton.class, "Polygon").isSelected());
        driver.robot().type(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame("the polygon is gone", frame -> obstacle(frame, "polygon").isEmpty());
    }

    @Test
    void aRectangleIsDrawnResizedDuplicatedAndDeleted() {
        driver.choose("snapGrid");
        driver.choose("placeRectangle");
        drag(point(6, 1.5), point(7, 2));
        waitForObstacle("it is as large as drawn", "rectangle", box -> box.shape().equals(new ObstacleShape.Rectangle(1, 0.5)));
        waitForSelection("rectangle");
        drag(point(7, 1.75), point(7.3, 1.75));
        waitForObstacle("it is wider", "rectangle", box -> box.shape().equals(new ObstacleShape.Rectangle(1.3, 0.5)));
        driver.robot().type(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
        waitForSelection("rectangle-2");
        driver.robot().type(KeyEvent.VK_DELETE);
        driver.waitForFrame("the copy is gone", frame -> obstacle(frame, "rectangle-2").isEmpty());
    }

    @Test
    void obstaclesGoOverTheClipboardAsText() {
        driver.robot().holding(KeyEvent.VK_SHIFT, () -> drag(point(2.9, 3.9), point(3.6, 3.1)));
        waitForSelection("chair-1");
        driver.robot().type(KeyEvent.VK_CONTROL, KeyEvent.VK_C);
        driver.robot().type(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
        waitForObstacle("the copy is there", "chair-3", copy -> true);
    }

    @Test
    void whatWouldOverlapTheRobotIsRefusedWithAReason() {
        driver.choose("placeCircle");
        click(2, 1.8);
        driver.robot().waitFor("the status bar says why", () -> Components.all(driver.window(), JLabel.class)
                .anyMatch(label -> "circle cannot be put there: it would overlap the robot".equals(label.getText())));
        assertTrue(obstacle(driver.frame(), "circle").isEmpty());
        click(6.5, 2);
        waitForObstacle("it is put elsewhere", "circle", circle -> true);
    }

    @Test
    void anObstacleIsGivenAWayByClicks() {
        click(4.7, 2.5);
        waitForSelection("chair-2");
        driver.choose("drawWay");
        click(6.5, 2.5);
        driver.robot().type(KeyEvent.VK_ENTER);
        waitForObstacle("it has a way to there and back", "chair-2", chair -> chair.motion().filter(way -> way.points().size() == 2).isPresent());
    }

    @Test
    void theSpeedOnAWayIsAskedForAndUndone() {
        anObstacleIsGivenAWayByClicks();
        EventQueue.invokeLater(() -> driver.chooseNow("waySpeed"));
        JDialog dialog = driver.dialog("Speed of moving obstacles");
        JTextField field = Components.all(dialog, JTextField.class).findFirst().orElseThrow();
        driver.robot().waitFor("the field has the focus", field::isFocusOwner);
        driver.robot().type(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        driver.robot().type(KeyEvent.VK_1);
        driver.answer("Speed of moving obstacles", "OK");
        waitForObstacle("it goes at 1 m/s", "chair-2", chair -> chair.motion().orElseThrow().speed() == 1);
        driver.robot().waitFor("the edit has a name", () -> "Undo Speed of chair-2".equals(undo().getText()));
        driver.choose("undo");
        waitForObstacle("it goes as it did", "chair-2", chair -> chair.motion().orElseThrow().speed() == 0.2);
    }

    private JMenuItem undo() {
        return Components.all(driver.window(), JMenuItem.class).filter(item -> "undo".equals(item.getActionCommand())).findFirst().orElseThrow();
    }

    @Test
    void theRobotIsDraggedToAnotherStartAndBackByUndo() {
        drag(point(2, 1.8), point(2.5, 2));
        driver.waitForFrame("it starts elsewhere", frame -> frame.world().pose().position().distanceTo(new Vec(2.5, 2)) < 0.03);
        driver.robot().type(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame("it starts where it did", frame -> frame.world().pose().position().equals(new Vec(2, 1.8)));
        driver.robot().waitFor("the window says that nothing is changed", () -> !isMarkedChanged());
    }

    @Test
    void aConeIsSelectedByAClickAndItsRangeDraggedByTheRim() {
        Sector cone = driver.frame().world().sensors().get(4).sector();
        Vec inside = onScreen(cone.apex().plus(cone.axis().times(cone.range() / 2)));
        driver.robot().click(driver.canvas(), inside.x(), inside.y(), LEFT);
        Vec rim = onScreen(cone.apex().plus(cone.axis().times(cone.range())));
        Vec farther = onScreen(cone.apex().plus(cone.axis().times(1.2)));
        drag(rim, farther);
        driver.waitForFrame("the range is larger", frame -> Math.abs(frame.world().sensors().get(4).spec().range() - 1.2) < 0.02);
    }

    @Test
    void presetsSwitchSensorsInOneEdit() {
        driver.choose("sensorsTwo");
        driver.waitForFrame("two are on", frame -> on(frame).equals(List.of("front", "left")));
        driver.choose("sensorsThree");
        driver.waitForFrame("three are on", frame -> on(frame).equals(List.of("front", "left", "front-right")));
        times(2, KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame("all are on", frame -> on(frame).size() == 8);
    }

    private static List<String> on(Frame frame) {
        return frame.world().robot().sensors().stream().filter(SensorSpec::on).map(SensorSpec::id).toList();
    }
}
