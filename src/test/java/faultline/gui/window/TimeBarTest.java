package faultline.gui.window;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.gui.Components;
import faultline.gui.EdtChecker;
import faultline.gui.Patience;
import faultline.gui.document.Bench;
import faultline.gui.document.BenchListener;
import faultline.gui.document.Filing;
import faultline.gui.document.RunDesk;
import faultline.gui.document.Task;
import faultline.gui.theme.Theme;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JSlider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Going along a run and back, without a display. */
@ExtendWith(EdtChecker.class)
class TimeBarTest {

    private static final int TICKS = 40;
    private static final double DT = 0.01;

    private final List<Frame> previews = new ArrayList<>();
    private Bench bench;
    private RunDesk run;
    private TimeBar bar;
    private JSlider slider;

    @BeforeEach
    void runAWhile() {
        edt(() -> {
            Theme.LIGHT.install();
            bench = new Bench(new Quiet());
            run = new RunDesk(bench);
            bar = new TimeBar(run.travel()::goTo, previews::add);
            slider = Components.all(bar, JSlider.class).findFirst().orElseThrow();
            new Filing(bench).open(Path.of("scenarios/office.xml"));
        });
        Patience.waitFor("the scenario", () -> run.frame().isPresent());
        for (int i = 0; i < TICKS; i++) {
            edt(run::step);
        }
        waitForTick(TICKS);
    }

    @AfterEach
    void close() {
        edt(bench::close);
    }

    @Test
    void theThumbStandsAtTheEndOfARunThatGoesOn() {
        assertEquals(TICKS, onEdt(slider::getMaximum));
        assertEquals(TICKS, onEdt(slider::getValue));
    }

    @Test
    void letGoSomewhereTheRunGoesThereToTheBitAndItsFutureIsKept() {
        long hash = onEdt(() -> run.frame().orElseThrow().trajectoryHash());
        edt(() -> slider.setValue(15));
        waitForTick(15);
        assertEquals(TICKS, onEdt(slider::getMaximum));
        edt(() -> slider.setValue(TICKS));
        waitForTick(TICKS);
        assertEquals(hash, onEdt(() -> run.frame().orElseThrow().trajectoryHash()));
    }

    @Test
    void whileTheThumbIsHeldARememberedPictureShowsAndTheRunStaysWhereItIs() {
        edt(() -> {
            slider.setValueIsAdjusting(true);
            slider.setValue(3);
        });
        assertTrue(onEdt(bar::isHeld));
        assertTrue(onEdt(() -> previews.get(previews.size() - 1).world().tick()) <= 3);
        waitForTick(TICKS);
        assertEquals(3, onEdt(slider::getValue), "the bar leaves the thumb to the hand");
        edt(() -> slider.setValueIsAdjusting(false));
        waitForTick(3);
    }

    @Test
    void aClickOnTheLineGoesToTheMomentThatIsThere() {
        edt(() -> slider.setSize(400 + 15, 24));
        // The thumb, 15 pixels wide, keeps half of its width from the ends.
        edt(() -> press(MouseEvent.MOUSE_PRESSED, 7 + 100));
        assertEquals(TICKS / 4, onEdt(slider::getValue));
        assertTrue(onEdt(bar::isHeld));
        edt(() -> press(MouseEvent.MOUSE_RELEASED, 7 + 100));
        waitForTick(TICKS / 4);
    }

    private void press(int type, int x) {
        slider.dispatchEvent(new MouseEvent(slider, type, 0, InputEvent.BUTTON1_DOWN_MASK, x, 3, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    void aRestartForgetsTheOldFuture() {
        edt(run::restart);
        waitForTick(0);
        assertEquals(0, onEdt(run.travel()::furthest));
        assertEquals(0, onEdt(slider::getMaximum));
    }

    @Test
    void aRunThatIsSavedShowsItsEndBeforeItsFirstTick() {
        edt(run::restart);
        waitForTick(0);
        edt(() -> bar.show(run.frame().orElseThrow(), 1200, 0.02));
        assertEquals(List.of("0.00 s", "24.00 s"), onEdt(() -> Components.all(bar, JLabel.class).map(label -> label.getText().strip()).toList()));
    }

    private void waitForTick(long tick) {
        Patience.waitFor("tick " + tick, () -> {
            Frame frame = run.frame().orElseThrow();
            bar.show(frame, run.travel().furthest(), DT);
            return frame.world().tick() == tick;
        });
    }

    /** Nothing here fails. */
    private static final class Quiet implements BenchListener {
        @Override
        public void begun() {
            // Frames are asked for.
        }

        @Override
        public void renamed() {
            // Nobody reads the title.
        }

        @Override
        public void failed(Task what, Path file, Throwable why) {
            throw new AssertionError(why);
        }
    }
}
