package faultline.gui.document;

import java.nio.file.Path;

/** A background task of the workspace, and the file that it works on, or the name of a scenario without a file. */
public record WorkspaceTask(TaskKind kind, Path name, TaskProgress progress) {

    WorkspaceTask(TaskKind kind, Path name) {
        this(kind, name, new TaskProgress());
    }
}
