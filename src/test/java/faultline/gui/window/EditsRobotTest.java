package faultline.gui.window;

import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Frame;
import faultline.geometry.Vec;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
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
}
