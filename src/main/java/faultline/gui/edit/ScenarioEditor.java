package faultline.gui.edit;

import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.gui.change.Rename;
import faultline.gui.document.RunController;
import faultline.gui.text.Messages;
import faultline.scenario.Scenario;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/** Changes the scenario itself, with undo. The run is simulated again if a change affects it. */
public final class ScenarioEditor {

    private final RunController run;
    private final UndoController undo;

    /** A change of the scenario, what reverts it, and what is called then. */
    private record RevertibleChange(
            RunController run, UnaryOperator<Scenario> change, UnaryOperator<Scenario> inverse, Runnable onUndone)
            implements SetupChange {
        @Override
        public void undo() {
            run.change(inverse);
            onUndone.run();
        }

        @Override
        public void redo() {
            run.change(change);
        }

        @Override
        public boolean isNoOp() {
            return run.haveSameEffect(change, inverse);
        }

        @Override
        public SetupChange mergedWith(SetupChange later) {
            return later instanceof RevertibleChange next
                    ? new RevertibleChange(run, next.change, inverse, onUndone)
                    : SetupChange.super.mergedWith(later);
        }
    }

    /** A move of the robot's start. */
    private static final class StartMove implements SetupChange {

        private final RunController run;
        private final Pose after;
        /** Set again when the start is moved: an earlier move may still have been to come. */
        private Pose before;

        StartMove(RunController run, Pose before, Pose after) {
            this.run = run;
            this.before = before;
            this.after = after;
        }

        @Override
        public void undo() {
            // A move that is still to be made is made before this.
            run.moveStart(start -> before);
        }

        @Override
        public void redo() {
            run.moveStart(start -> {
                before = start;
                return after;
            });
        }
    }

    public ScenarioEditor(RunController run, UndoController undo) {
        this.run = run;
        this.undo = undo;
    }

    /**
     * Changes the scenario, given the key of the edit's name and the change that reverts only this change. Changes with
     * the same name in quick succession form one edit.
     */
    public void edit(String key, UnaryOperator<Scenario> change, UnaryOperator<Scenario> inverse) {
        edit(() -> Messages.get(key), key, change, inverse);
    }

    /**
     * Changes the scenario, given the name of the edit in the current language, its target, the change, and the change
     * that reverts only this change. Changes with equal targets in quick succession form one edit.
     */
    public void edit(
            Supplier<String> name, Object target, UnaryOperator<Scenario> change, UnaryOperator<Scenario> inverse) {
        edit(name, target, change, inverse, () -> {});
    }

    /** Changes the scenario; {@code onUndone} is called when that has been undone. */
    void edit(
            Supplier<String> name,
            Object target,
            UnaryOperator<Scenario> change,
            UnaryOperator<Scenario> inverse,
            Runnable onUndone) {
        undo.addSetupEdit(name, target, new RevertibleChange(run, change, inverse, onUndone));
        run.change(change);
    }

    /** Makes an edit as soon as the run has answered the edits that are being undone or redone. */
    void editWhenAnswered(Runnable edit) {
        undo.editWhenAnswered(edit);
    }

    /** Makes all events of the run commands of the timeline, where they are undone. */
    void putEventsOnTimeline() {
        run.putEventsOnTimeline();
    }

    /** Changes the id of a sensor or an obstacle. */
    void rename(Rename rename) {
        undo.addRename(rename, run::rename);
        run.rename(rename);
    }

    /** Moves the robot's start, which restarts the run, given the setup of the run. */
    public void moveStart(SimulationSetup setup, Pose after) {
        StartMove move = new StartMove(run, setup.start(), after);
        move.redo();
        undo.addSetupEdit(() -> Messages.get("edit.start"), after, move);
    }
}
