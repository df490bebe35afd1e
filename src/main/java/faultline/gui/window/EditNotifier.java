package faultline.gui.window;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.document.Workspace;
import faultline.gui.text.Messages;
import java.util.function.Consumer;

/** Reports the effects of an edit on the run. */
final class EditNotifier {

    private final Workspace workspace;
    private final ActionRegistry actions;
    private final Consumer<String> notifier;

    EditNotifier(Workspace workspace, ActionRegistry actions, Consumer<String> notifier) {
        this.workspace = workspace;
        this.actions = actions;
        this.notifier = notifier;
    }

    void timelineForked(int later) {
        notifier.accept(Messages.get("edit.forked", Integer.toString(later)));
    }

    /** Explains why the run does not show that an edit has been undone or redone. */
    void editChangedScenario(String name, boolean redone) {
        notifier.accept(Messages.get(redone ? "edit.redoneInScenario" : "edit.undoneInScenario", name));
    }

    /** Explains that undoing an edit does not undo a collision that happened after it. */
    void editUndone(long since) {
        workspace
                .session()
                .flatMap(session -> session.frame().snapshot().collision())
                .filter(collision -> collision.tick() >= since)
                .ifPresent(collision -> notifier.accept(
                        Messages.get("edit.crashStays", keystrokeText("stepBack"), keystrokeText("restart"))));
    }

    private String keystrokeText(String action) {
        return actions.get(action).accelerator().map(Keystrokes::toText).orElseThrow();
    }
}
