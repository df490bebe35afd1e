package faultline.gui.edit;

import faultline.engine.SimulationSetup;
import faultline.gui.document.RunController;
import faultline.gui.document.TaskKind;
import faultline.gui.document.WorkspaceListener;
import java.nio.file.Path;

/** Tells a history of edits what becomes of the run, as the window does. A task that fails is an error. */
public final class UndoForwarder implements WorkspaceListener {

    private final RunController run;
    private final UndoController undo;

    public UndoForwarder(RunController run, UndoController undo) {
        this.run = run;
        this.undo = undo;
        undo.setPlan(run::plannedSince);
        undo.setRepositioning(run::isRepositioning);
    }

    @Override
    public void scenarioOpened() {
        undo.clear();
    }

    @Override
    public void scenarioRestarted(SimulationSetup before) {
        undo.runRestarted(before, run);
    }

    @Override
    public void editsIncluded(SimulationSetup before) {
        undo.runRestarted(before, run);
    }

    @Override
    public void runRepositioned(long tick, SimulationSetup setup, boolean eventsOnTimeline) {
        undo.runRepositioned(tick, setup, eventsOnTimeline, run);
    }

    @Override
    public void taskFinished() {
        undo.taskFinished();
    }

    @Override
    public void taskFailed(TaskKind task, Path file, Throwable failure) {
        throw new AssertionError(failure);
    }
}
