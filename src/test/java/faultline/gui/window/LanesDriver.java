package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;

import faultline.gui.ComponentFinder;
import faultline.gui.timeline.LaneView;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import javax.swing.JSlider;

/** Drives one lane of the time line of a window with a scenario of 180 s. */
final class LanesDriver {

    private static final double DURATION = 180;

    private final WindowDriver driver;
    private final LaneView lanes;
    private final double laneY;

    /** Finds a lane by its number from 0. The ruler is 14 pixels high; each of 11 lanes is 12 to 17 pixels high. */
    LanesDriver(WindowDriver driver, int lane) {
        this.driver = driver;
        lanes = ComponentFinder.findAll(driver.window(), LaneView.class)
                .findFirst()
                .orElseThrow();
        driver.robot().waitFor("the lanes", () -> lanes.isShowing());
        laneY = 14 + (lane + 0.5) * callOnEdt(() -> Math.min(17, Math.max(12, (lanes.getHeight() - 14) / 11)));
    }

    LaneView view() {
        return lanes;
    }

    private void showLane() {
        runOnEdt(() -> lanes.scrollRectToVisible(new Rectangle(0, (int) laneY - 5, 1, 10)));
    }

    private double x(double time) {
        JSlider slider = ComponentFinder.find(driver.window(), JSlider.class, "Time line");
        return callOnEdt(() -> slider.getLocationOnScreen().x
                - lanes.getLocationOnScreen().x
                + 7
                + time / DURATION * (slider.getWidth() - 15));
    }

    void click(double time) {
        showLane();
        driver.robot().click(lanes, x(time), laneY, InputEvent.BUTTON1_DOWN_MASK);
    }

    void doubleClick(double time) {
        showLane();
        driver.robot().doubleClick(lanes, x(time), laneY);
    }

    void drag(double from, double to) {
        showLane();
        driver.robot().drag(lanes, x(from), laneY, x(to), laneY, InputEvent.BUTTON1_DOWN_MASK);
    }
}
