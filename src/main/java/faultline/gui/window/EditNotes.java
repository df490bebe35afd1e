package faultline.gui.window;

import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.document.RunDesk;
import faultline.gui.edit.EditNews;
import faultline.gui.text.Texts;
import java.util.function.Consumer;

/** Tells the user what else an edit means for the run. */
final class EditNotes implements EditNews {

    private final RunDesk run;
    private final UiActions actions;
    private final Consumer<String> told;

    EditNotes(RunDesk run, UiActions actions, Consumer<String> told) {
        this.run = run;
        this.actions = actions;
        this.told = told;
    }

    @Override
    public void forked(int later) {
        told.accept(Texts.text("edit.forked", Integer.toString(later)));
    }

    /** Who takes back what the robot has run into may think that it will drive on. */
    @Override
    public void undone(long since) {
        run.frame().flatMap(frame -> frame.world().collision()).filter(collision -> collision.tick() >= since)
                .ifPresent(collision -> told.accept(Texts.text("edit.crashStays", key("stepBack"), key("restart"))));
    }

    private String key(String action) {
        return actions.get(action).stroke().map(Keystrokes::text).orElseThrow();
    }
}
