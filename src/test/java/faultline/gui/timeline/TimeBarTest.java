package faultline.gui.timeline;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.session.SessionFrame;
import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TaskKind;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.theme.Theme;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleValue;
import javax.swing.JLabel;
import javax.swing.JSlider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Seeking in a run without a display. */
@ExtendWith(EdtChecker.class)
class TimeBarTest {

    private static final int TICKS = 40;

    private final List<Frame> previews = new ArrayList<>();
    private Workspace workspace;
    private RunController run;
    private TimeBar bar;
    private JSlider slider;

    @BeforeEach
    void runAWhile() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            workspace = new Workspace();
            workspace.addListener(new NoOpListener());
            run = new RunController(workspace);
            bar = new TimeBar(run.navigator()::seek, previews::add);
            slider = ComponentFinder.findAll(bar, JSlider.class).findFirst().orElseThrow();
            new DocumentStore(workspace).open(Path.of("scenarios/office.xml"));
        });
        SessionFrames.awaitScenario(workspace);
        for (int i = 0; i < TICKS; i++) {
            runOnEdt(run::step);
        }
        waitForTick(TICKS);
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    @Test
    void theThumbStandsAtTheEndOfARunThatGoesOn() {
        assertEquals(TICKS, callOnEdt(slider::getMaximum));
        assertEquals(TICKS, callOnEdt(slider::getValue));
    }

    @Test
    void releasingTheThumbSeeksExactlyAndKeepsTheFuture() {
        long hash = SessionFrames.trajectoryHash(workspace);
        runOnEdt(() -> slider.setValue(15));
        waitForTick(15);
        assertEquals(TICKS, callOnEdt(slider::getMaximum));
        runOnEdt(() -> slider.setValue(TICKS));
        waitForTick(TICKS);
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
    }

    @Test
    void theTimeOfARunOfDaysIsNotClipped() {
        runOnEdt(() -> {
            bar.setLeadingWidth(20);
            JLabel time = ComponentFinder.findAll(bar, JLabel.class).findFirst().orElseThrow();
            time.setText("1576110.61 s");
            assertTrue(time.getPreferredSize().width
                    >= time.getFontMetrics(time.getFont()).stringWidth(time.getText()));
        });
    }

    @Test
    void draggingTheThumbPreviewsAKeyframeWithoutSeeking() {
        runOnEdt(() -> {
            slider.setValueIsAdjusting(true);
            slider.setValue(3);
        });
        assertTrue(callOnEdt(bar::isAdjusting));
        assertTrue(callOnEdt(() -> previews.get(previews.size() - 1).snapshot().tick()) <= 3);
        waitForTick(TICKS);
        assertEquals(3, callOnEdt(slider::getValue), "the bar leaves the thumb to the hand");
        runOnEdt(() -> slider.setValueIsAdjusting(false));
        waitForTick(3);
    }

    @Test
    void aClickOnTheLineGoesToTheMomentThatIsThere() {
        runOnEdt(() -> slider.setSize(400 + 15, 24));
        // The thumb, 15 pixels wide, keeps half of its width from the ends.
        runOnEdt(() -> press(MouseEvent.MOUSE_PRESSED, 7 + 100));
        assertEquals(TICKS / 4, callOnEdt(slider::getValue));
        assertTrue(callOnEdt(bar::isAdjusting));
        runOnEdt(() -> press(MouseEvent.MOUSE_RELEASED, 7 + 100));
        waitForTick(TICKS / 4);
    }

    /** A scenario can be opened by the keyboard while the thumb is dragged. */
    @Test
    void aDragEndsWithItsScenario() {
        runOnEdt(() -> {
            slider.setSize(400 + 15, 24);
            press(MouseEvent.MOUSE_PRESSED, 7 + 100);
            bar.startScenario();
            assertFalse(bar.isAdjusting());
            press(MouseEvent.MOUSE_DRAGGED, 7 + 200);
            assertFalse(bar.isAdjusting());
            press(MouseEvent.MOUSE_RELEASED, 7 + 200);
            assertTrue(workspace.task().isEmpty(), "the run is moved");
        });
    }

    private void press(int type, int x) {
        slider.dispatchEvent(
                new MouseEvent(slider, type, 0, InputEvent.BUTTON1_DOWN_MASK, x, 3, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    void screenReadersGetAndSetTheTimeInSeconds() {
        runOnEdt(() -> {
            AccessibleValue value = slider.getAccessibleContext().getAccessibleValue();
            assertEquals(0.4, value.getCurrentAccessibleValue());
            assertEquals(0.0, value.getMinimumAccessibleValue());
            assertEquals(0.4, value.getMaximumAccessibleValue());
            assertTrue(value.setCurrentAccessibleValue(0.2));
        });
        waitForTick(20);
    }

    @Test
    void screenReadersHearOfTheTimeInSeconds() {
        runOnEdt(() -> {
            List<Object> times = new ArrayList<>();
            slider.getAccessibleContext().addPropertyChangeListener(event -> {
                if (event.getPropertyName().equals(AccessibleContext.ACCESSIBLE_VALUE_PROPERTY)) {
                    times.add(event.getOldValue());
                    times.add(event.getNewValue());
                }
            });
            slider.setValue(15);
            assertEquals(List.of(0.4, 0.15), times);
        });
        waitForTick(15);
    }

    @Test
    void aRestartForgetsTheOldFuture() {
        runOnEdt(run::restart);
        waitForTick(0);
        assertEquals(0, callOnEdt(run.navigator()::furthestTick));
        assertEquals(0, callOnEdt(slider::getMaximum));
    }

    @Test
    void aRunThatIsSavedShowsItsEndBeforeItsFirstTick() {
        runOnEdt(run::restart);
        waitForTick(0);
        runOnEdt(() -> bar.setFrame(startWithTicksOf(0.02), 1200));
        assertEquals(List.of("0.00 s", "24.00 s"), callOnEdt(this::shownTimes));
    }

    @Test
    void timesAreShownToTheTick() {
        runOnEdt(run::restart);
        waitForTick(0);
        runOnEdt(() -> bar.setFrame(startWithTicksOf(0.0125), 3));
        assertEquals(List.of("0.0000 s", "0.0375 s"), callOnEdt(this::shownTimes));
        assertEquals("0.0250", callOnEdt(() -> bar.tickText(2)));
    }

    private SessionFrame startWithTicksOf(double dt) {
        SessionFrame start = SessionFrames.frame(workspace);
        return new SessionFrame(
                start.frame(), start.recording(), start.measures(), start.controller(), start.controllerName(), dt);
    }

    private List<String> shownTimes() {
        return ComponentFinder.findAll(bar, JLabel.class)
                .map(label -> label.getText().strip())
                .toList();
    }

    private void waitForTick(long tick) {
        Await.until("tick " + tick, () -> {
            SessionFrame frame = SessionFrames.frame(workspace);
            bar.setFrame(frame, run.navigator().furthestTick());
            return frame.snapshot().tick() == tick;
        });
    }

    /** A listener that ignores all events. */
    private static final class NoOpListener implements WorkspaceListener {
        @Override
        public void taskFailed(TaskKind what, Path file, Throwable why) {
            throw new AssertionError(why);
        }
    }
}
