package faultline.gui.window;

import static faultline.gui.action.Keystrokes.menu;
import static faultline.gui.action.Keystrokes.plain;
import static faultline.gui.action.Keystrokes.sign;

import faultline.engine.Session;
import faultline.gui.action.UiAction;
import faultline.gui.document.RunDesk;
import faultline.gui.theme.Glyph;
import java.awt.event.KeyEvent;
import java.util.function.IntConsumer;
import java.util.function.IntUnaryOperator;
import javax.swing.BoundedRangeModel;

/** The actions on the run: run and pause, step, restart, the speed, and the switches of the sensors. */
final class RunActions {

    private static final int SENSOR_KEYS = 8;

    private final RunDesk desk;
    private final BoundedRangeModel speed;
    private final UiAction run;
    private boolean running;

    RunActions(RunDesk desk, BoundedRangeModel speed) {
        this.desk = desk;
        this.speed = speed;
        this.run = UiAction.of("run", desk::toggleRunning).on(plain(KeyEvent.VK_SPACE)).drawn(Glyph.RUN);
        speed.addChangeListener(event -> desk.setSpeed(SpeedScale.speed(speed.getValue())));
    }

    void addTo(UiActions actions, IntConsumer toggleSensor) {
        actions.add(run);
        actions.add(UiAction.of("step", desk::step).on(sign('.')).drawn(Glyph.STEP));
        actions.add(UiAction.of("stepBack", desk.travel()::stepBack).on(sign(',')).drawn(Glyph.STEP_BACK));
        actions.add(UiAction.of("restart", desk::restart).on(menu(KeyEvent.VK_R)).drawn(Glyph.RESTART));
        actions.add(UiAction.of("slower", () -> change(SpeedScale::slower)).on(sign('[')));
        actions.add(UiAction.of("faster", () -> change(SpeedScale::faster)).on(sign(']')));
        actions.add(UiAction.of("realTime", () -> speed.setValue(SpeedScale.REAL_TIME)).on(sign('\\')));
        for (int i = 0; i < SENSOR_KEYS; i++) {
            int index = i;
            actions.add(UiAction.of("sensor" + (i + 1), () -> toggleSensor.accept(index)).on(plain(KeyEvent.VK_1 + i)));
        }
    }

    private void change(IntUnaryOperator next) {
        speed.setValue(next.applyAsInt(speed.getValue()));
    }

    /** Makes the one action say Run or Pause. */
    void show(Session.Status status) {
        if (status.running() != running) {
            running = status.running();
            run.rename(running ? "pause" : "run");
            run.drawn(running ? Glyph.PAUSE : Glyph.RUN);
        }
    }
}
