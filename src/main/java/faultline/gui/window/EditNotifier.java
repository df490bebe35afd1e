package faultline.gui.window;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.document.RunController;
import faultline.gui.text.Messages;
import java.util.function.Consumer;

/** Reports the effects of an edit on the run. */
final class EditNotifier {

    private final RunController runController;
    private final ActionRegistry actions;
    private final Consumer<String> notifier;

    EditNotifier(RunController run, ActionRegistry actions, Consumer<String> notifier) {
        this.runController = run;
        this.actions = actions;
        this.notifier = notifier;
    }

    void timelineForked(int later) {
        notifier.accept(Messages.get("edit.forked", Integer.toString(later)));
    }

    /** Explains that undoing an edit does not undo a collision that happened after it. */
    void editUndone(long since) {
        runController
                .frame()
                .flatMap(frame -> frame.snapshot().collision())
                .filter(collision -> collision.tick() >= since)
                .ifPresent(collision -> notifier.accept(
                        Messages.get("edit.crashStays", keystrokeText("stepBack"), keystrokeText("restart"))));
    }

    private String keystrokeText(String action) {
        return actions.get(action).accelerator().map(Keystrokes::toText).orElseThrow();
    }
}
