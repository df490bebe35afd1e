package faultline.gui.window;

import faultline.engine.Frame;
import faultline.gui.document.RunNavigator;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import java.util.OptionalLong;
import java.util.function.Consumer;

/** Notifies the user that a saved run is open, and when its replay has ended. */
final class ReplayNotifier {

    private final RunNavigator runNavigator;
    private final Consumer<String> notifier;
    private boolean announced;
    private boolean ended;

    ReplayNotifier(RunNavigator runNavigator, Consumer<String> notifier) {
        this.runNavigator = runNavigator;
        this.notifier = notifier;
    }

    /** Prepares for a new session. */
    void reset() {
        announced = false;
        ended = false;
    }

    /** Checks whether the replay has ended. */
    void update(Frame frame) {
        OptionalLong end = runNavigator.replayEnd();
        if (end.isPresent()) {
            update(frame.snapshot().tick(), end.getAsLong(), frame.snapshot().time());
        }
    }

    private void update(long tick, long end, double time) {
        if (tick == end && !ended) {
            notifier.accept(Messages.get("replay.ended", NumberText.format("%.2f", time)));
        } else if (tick == 0 && !announced) {
            notifier.accept(Messages.get("replay.begun"));
        }
        announced = true;
        ended = tick == end;
    }
}
