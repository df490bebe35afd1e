package faultline.gui.window;

import faultline.engine.SimulationSetup;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.Notes;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.edit.ForkedEdits;
import faultline.gui.text.Messages;
import faultline.gui.timeline.CommandRole;
import faultline.gui.timeline.TimelineItem;
import faultline.gui.timeline.TimelineText;
import faultline.world.Collision;
import faultline.world.CommandResult;
import java.util.List;

/** Reports the effects of an edit on the run, and why an edit or Run has none. */
final class EditNotifier implements WorkspaceListener {

    private final Workspace workspace;
    private final ActionRegistry actions;
    private final Notes notes;
    private String failureNote = "";

    EditNotifier(Workspace workspace, ActionRegistry actions, Notes notes) {
        this.workspace = workspace;
        this.actions = actions;
        this.notes = notes;
    }

    void timelineForked(ForkedEdits forked) {
        String edits = Integer.toString(forked.edits());
        String undos = Integer.toString(forked.undos());
        if (forked.undos() == 0) {
            notes.show(Messages.get("edit.forked", edits));
        } else if (forked.edits() == 0) {
            notes.show(Messages.get("edit.forked.undos", undos));
        } else {
            notes.show(Messages.get("edit.forked.both", edits, undos));
        }
    }

    /** Explains why the run does not show that an edit has been undone or redone. */
    void editChangedScenario(String name, boolean redone) {
        notes.show(Messages.get(redone ? "edit.redoneInScenario" : "edit.undoneInScenario", name));
    }

    /** Says that a fault has been added to an equal one, since the list of faults then only has one more such row. */
    void editMade(List<CommandResult> results) {
        results.stream()
                // The inverse contains what adds the faults that there were before.
                .filter(result -> result.inverse().contains(result.command())
                        && CommandRole.of(result.command()).isFaultStart())
                .map(result -> TimelineText.title(TimelineItem.from(result.command(), 0)))
                .forEach(fault -> notes.show(Messages.get("faults.again", fault)));
    }

    /** Explains that undoing an edit does not undo a collision that happened after it. */
    void editUndone(long since) {
        workspace
                .session()
                .flatMap(session -> session.frame().snapshot().collision())
                .filter(collision -> collision.tick() >= since)
                .map(this::adviceAfter)
                .ifPresent(notes::show);
    }

    /** Returns how to undo a collision; there is nothing to step back to before one at the start. */
    private String adviceAfter(Collision collision) {
        return collision.time() == 0
                ? Messages.get("edit.crashStaysAtStart", keystrokeText("restart"))
                : Messages.get("edit.crashStays", keystrokeText("stepBack"), keystrokeText("restart"));
    }

    @Override
    public void setupChangeDeferred() {
        notes.show(Messages.get("edit.deferred"));
    }

    /** Explains what to do; there is no earlier time to move a run to that has failed at its start. */
    @Override
    public void failedRunResumed() {
        boolean atStart = workspace
                .session()
                .filter(session -> session.frame().snapshot().tick() == 0)
                .isPresent();
        failureNote = Messages.get(atStart ? "run.failedAtStart" : "run.failed", keystrokeText("restart"));
        notes.show(failureNote);
    }

    @Override
    public void scenarioRestarted(SimulationSetup before) {
        notes.remove(failureNote);
    }

    @Override
    public void runRepositioned(long tick, SimulationSetup setup, boolean eventsOnTimeline) {
        notes.remove(failureNote);
    }

    private String keystrokeText(String action) {
        return actions.get(action).accelerator().map(Keystrokes::toText).orElseThrow();
    }
}
