package faultline.gui.document;

import java.nio.file.Path;

/** Lets a test fail if a task of the workspace fails. */
public final class TaskFailures implements WorkspaceListener {

    @Override
    public void taskFailed(TaskKind task, Path file, Throwable failure) {
        throw new AssertionError(failure);
    }
}
