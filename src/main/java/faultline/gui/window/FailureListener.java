package faultline.gui.window;

import faultline.gui.dialog.ControllerActions;
import faultline.gui.dialog.Dialogs;
import faultline.gui.document.TaskKind;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import java.nio.file.Path;

/** Shows why a task failed. If no scenario is open because the first one failed to open, an example is opened. */
final class FailureListener implements WorkspaceListener {

    private final Workspace workspace;
    private final ControllerActions controllerActions;
    private final Dialogs dialogs;
    private final Runnable openExample;
    /** Whether the example has been opened, so that one that fails to open is not opened again. */
    private boolean exampleOpened;

    /**
     * Creates a listener.
     *
     * @param openExample opens the example in place of the first scenario
     */
    FailureListener(Workspace workspace, ControllerActions controllerActions, Dialogs dialogs, Runnable openExample) {
        this.workspace = workspace;
        this.controllerActions = controllerActions;
        this.dialogs = dialogs;
        this.openExample = openExample;
    }

    @Override
    public void taskFailed(TaskKind task, Path file, Throwable failure) {
        boolean opens = task == TaskKind.OPEN;
        if (opens && controllerActions.openFailed(failure)) {
            dialogs.showControllerFailure(file, failure);
            return;
        }
        boolean keepsScenario = !opens || workspace.scenario().isPresent();
        if (!keepsScenario && !exampleOpened) {
            exampleOpened = true;
            openExample.run();
        }
        dialogs.showFailure(task, file, failure, keepsScenario);
    }
}
