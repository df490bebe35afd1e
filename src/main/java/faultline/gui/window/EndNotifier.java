package faultline.gui.window;

import faultline.engine.SimulationSetup;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import java.util.function.Consumer;

/** Notifies the user that a run continues after the end of its scenario. */
final class EndNotifier {

    private final Consumer<String> notifier;
    private boolean past;

    EndNotifier(Consumer<String> notifier) {
        this.notifier = notifier;
    }

    /**
     * Checks whether the run has passed the end of the edited scenario since the last call. The scenario's ticks may
     * have another length than those of the run, seconds, if a restart was cancelled.
     */
    void update(long tick, double dt, SimulationSetup edited) {
        double duration = edited.duration();
        boolean now = tick > SimulationSetup.tickAt(duration, dt);
        if (now && !past) {
            notifier.accept(Messages.get("run.pastEnd", NumberText.format("%.2f", duration)));
        }
        past = now;
    }
}
