package faultline.gui.window;

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

    /** Checks whether the run has passed the end of its scenario since the last call; both are numbers of ticks. */
    void update(long tick, long end, double duration) {
        boolean now = tick > end;
        if (now && !past) {
            notifier.accept(Messages.get("run.pastEnd", NumberText.format("%.2f", duration)));
        }
        past = now;
    }
}
