package faultline.gui.action;

import static faultline.gui.action.Keystrokes.character;
import static faultline.gui.action.Keystrokes.menuShortcut;
import static faultline.gui.action.Keystrokes.unmodified;

import faultline.engine.session.SessionStatus;
import faultline.gui.document.RunController;
import faultline.gui.theme.Glyph;
import java.awt.event.KeyEvent;
import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import java.util.function.IntUnaryOperator;
import javax.swing.BoundedRangeModel;

/** The actions that control the run: run and pause, step, restart, the time and the speed. */
public final class RunActions {

    private final RunController runController;
    private final BoundedRangeModel speedModel;
    private final UiAction runAction;
    private final UiAction stepBackAction;
    private final DoubleFunction<OptionalDouble> askTime;
    private boolean running;

    /**
     * Creates the actions. {@code askTime} asks for a time of the run, seconds, given the present one, and returns
     * empty if cancelled.
     */
    public RunActions(RunController runController, BoundedRangeModel speed, DoubleFunction<OptionalDouble> askTime) {
        this.runController = runController;
        this.askTime = askTime;
        this.speedModel = speed;
        this.runAction = UiAction.of("run", runController::toggleRunning)
                .withAccelerator(unmodified(KeyEvent.VK_SPACE))
                .withIcon(Glyph.RUN);
        this.stepBackAction = UiAction.of("stepBack", runController.navigator()::stepBack)
                .withAccelerator(character(','))
                .withIcon(Glyph.STEP_BACK);
        stepBackAction.setEnabled(false);
        speed.addChangeListener(event -> runController.setSpeed(SpeedScale.speedAt(speed.getValue())));
    }

    public void addTo(ActionRegistry actions) {
        actions.add(runAction);
        actions.add(UiAction.of("step", runController::step)
                .withAccelerator(character('.'))
                .withIcon(Glyph.STEP));
        actions.add(stepBackAction);
        actions.add(UiAction.of("goToTime", this::goToTime).withAccelerator(menuShortcut(KeyEvent.VK_T)));
        actions.add(UiAction.of("restart", runController::restartUnlessOpening)
                .withAccelerator(menuShortcut(KeyEvent.VK_R))
                .withIcon(Glyph.RESTART));
        actions.add(
                UiAction.of("slower", () -> changeSpeed(SpeedScale::nextSlower)).withAccelerator(character('[')));
        actions.add(
                UiAction.of("faster", () -> changeSpeed(SpeedScale::nextFaster)).withAccelerator(character(']')));
        actions.add(UiAction.of("realTime", () -> speedModel.setValue(SpeedScale.REAL_TIME_POSITION))
                .withAccelerator(character('\\')));
    }

    private void goToTime() {
        askTime.apply(runController.navigator().currentTime()).ifPresent(runController.navigator()::seekTime);
    }

    private void changeSpeed(IntUnaryOperator next) {
        speedModel.setValue(next.applyAsInt(speedModel.getValue()));
    }

    /** Names the run action Run or Pause, and enables the step back after the given tick unless it is 0. */
    public void update(SessionStatus status, long tick) {
        stepBackAction.setEnabled(tick > 0);
        if (status.running() != running) {
            running = status.running();
            runAction.rename(running ? "pause" : "run");
            runAction.withIcon(running ? Glyph.PAUSE : Glyph.RUN);
        }
    }
}
