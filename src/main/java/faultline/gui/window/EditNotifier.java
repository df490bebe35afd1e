package faultline.gui.window;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.document.RunController;
import faultline.gui.edit.EditListener;
import faultline.gui.text.Messages;
import java.util.function.Consumer;

/** Tells the user what else an edit means for the run. */
final class EditNotifier implements EditListener {

    private final RunController runController;
    private final ActionRegistry actions;
    private final Consumer<String> notifier;

    EditNotifier(RunController run, ActionRegistry actions, Consumer<String> told) {
        this.runController = run;
        this.actions = actions;
        this.notifier = told;
    }

    @Override
    public void timelineForked(int later) {
        notifier.accept(Messages.get("edit.forked", Integer.toString(later)));
    }

    /** Who takes back what the robot has run into may think that it will drive on. */
    @Override
    public void editUndone(long since) {
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
