package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.instrument.InstrumentDock;
import faultline.gui.panel.RunPanel;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.LaneView;
import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The tour is taken by keys alone, shows each control that it explains, and leaves the program usable. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class TourRobotTest {

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/cable.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private TourCard card() {
        return ComponentFinder.findAll(driver.window(), TourCard.class)
                .findFirst()
                .orElseThrow();
    }

    private void waitForStep(String title) {
        driver.robot()
                .waitFor(
                        "the step \"" + title + "\" shows",
                        () -> card().isShowing() && title.equals(ComponentFinder.accessibleName(card())));
    }

    private boolean isShowing(Class<? extends JComponent> part) {
        return callOnEdt(() -> ComponentFinder.findAll(driver.window(), part)
                .findFirst()
                .orElseThrow()
                .isShowing());
    }

    @Test
    void keysWalkThroughTheStepsAndEscapeClosesTheCard() {
        driver.choose("timeline");
        assertFalse(isShowing(LaneView.class));
        driver.choose("tour");
        waitForStep("1 of 4: Break a sensor");
        press("Next");
        waitForStep("2 of 4: Watch the health of the sensors");
        assertTrue(isShowing(RunPanel.class));
        press("Next");
        waitForStep("3 of 4: Plan a fault from 20 s to 40 s");
        assertTrue(isShowing(LaneView.class), "the tour shows the lanes that it explains");
        press("Next");
        waitForStep("4 of 4: Compare with a healthy robot");
        driver.robot().waitFor("the last button closes", () -> button("Close").isFocusOwner());
        driver.robot().pressKeys(KeyEvent.VK_SHIFT, KeyEvent.VK_TAB);
        press("Back");
        waitForStep("3 of 4: Plan a fault from 20 s to 40 s");
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the card is gone", () -> !card().isShowing());
        driver.robot().waitFor("the canvas has the focus", driver.canvas()::isFocusOwner);
    }

    @Test
    void theRunGoesOnWhileTheTourIsOpen() {
        driver.choose("tour");
        waitForStep("1 of 4: Break a sensor");
        driver.type(KeyEvent.VK_SPACE);
        driver.waitForFrame("time runs", frame -> frame.snapshot().time() > 0.3);
        assertTrue(callOnEdt(card()::isShowing));
    }

    @Test
    void aLowWindowHidesTheInstrumentsSoThatTheCardFits() {
        runOnEdt(() -> driver.window().setSize(800, 600));
        driver.robot().waitFor("the window is low", () -> driver.window().getHeight() == 600);
        if (!isShowing(InstrumentDock.class)) {
            driver.choose("instruments");
        }
        assertTrue(isShowing(InstrumentDock.class));
        driver.choose("tour");
        waitForStep("1 of 4: Break a sensor");
        assertFalse(isShowing(InstrumentDock.class));
        driver.robot()
                .waitFor(
                        "the card shows all of its text",
                        () -> card().getHeight() == card().sizeWithin(new Dimension(card().getWidth(), 2000)).height);
    }

    @Test
    void theGalleryOffersTheTour() {
        driver.chooseLater("examples");
        driver.clickButton("Examples", "Take the tour");
        waitForStep("1 of 4: Break a sensor");
        runOnEdt(() -> button("Close").doClick());
        driver.robot().waitFor("the card is gone", () -> !card().isShowing());
    }

    private void press(String button) {
        driver.robot().waitFor(button + " has the focus", () -> button(button).isFocusOwner());
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
    }

    private JButton button(String text) {
        return ComponentFinder.findAll(card(), JButton.class)
                .filter(one -> text.equals(one.getText()))
                .findFirst()
                .orElseThrow();
    }
}
