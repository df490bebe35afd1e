package faultline.gui.window;

import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.TaskKind;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.settings.RecentFiles;
import java.nio.file.Files;
import java.nio.file.Path;

/** Adds the files that are opened and saved to the recent files, and removes those that are missing. */
final class RecentFilesListener implements WorkspaceListener {

    private final Workspace workspace;
    private final RecentFiles recent;

    RecentFilesListener(Workspace workspace, RecentFiles recent) {
        this.workspace = workspace;
        this.recent = recent;
    }

    @Override
    public void scenarioOpened() {
        workspace.file().ifPresent(recent::add);
    }

    @Override
    public void scenarioSaved(Path file) {
        recent.add(file);
    }

    @Override
    public void taskFailed(TaskKind task, Path file, Throwable failure) {
        if (task == TaskKind.OPEN) {
            BackgroundTasks.compute(
                    () -> Files.notExists(file),
                    missing -> {
                        if (missing) {
                            recent.remove(file);
                        }
                    },
                    ignored -> {});
        }
    }
}
