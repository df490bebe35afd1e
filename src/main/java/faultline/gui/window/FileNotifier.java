package faultline.gui.window;

import faultline.gui.bar.StatusBar;
import faultline.gui.dialog.Dialogs;
import faultline.gui.document.FileNames;
import faultline.gui.document.RecoveryStore;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.scenario.xml.ScenarioException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;

/** Notifies the user of what becomes of files: that one is saved, and what is wrong with that of the scenario. */
final class FileNotifier implements WorkspaceListener {

    private final Workspace workspace;
    private final StatusBar statusBar;

    FileNotifier(Workspace workspace, StatusBar statusBar) {
        this.workspace = workspace;
        this.statusBar = statusBar;
    }

    @Override
    public void saveSlow(Path file, BooleanSupplier writing) {
        statusBar.keepNote(Messages.get("saving", FileNames.lastOf(file)), writing);
    }

    @Override
    public void scenarioSaved(Path file) {
        fileSaved(file);
    }

    @Override
    public void journalSaved(Path file) {
        fileSaved(file);
    }

    void fileSaved(Path file) {
        statusBar.showNote(Messages.get("saved", FileNames.lastOf(file)));
    }

    void fileBroken(ScenarioException exception) {
        statusBar.showNote(Dialogs.unreadableFileText(exception));
    }

    void fileDeleted(Path file) {
        statusBar.showNote(Messages.get("deleted", FileNames.lastOf(file)));
    }

    /** Notes that edits of several crashes were left, of which the window has recovered others. */
    void editsLeft(List<RecoveryStore.RecoveredFile> edits) {
        String names = edits.stream().map(RecoveryStore.RecoveredFile::name).collect(Collectors.joining(", "));
        statusBar.showNote(Messages.get("recover.others", names));
    }

    /** Notes that unsaved edits cannot be stored, for as long as that is so and there are any. */
    void autosaveFailed(Throwable failure, BooleanSupplier failing) {
        String sentence = Messages.get("recover.failed", ErrorMessages.describe(failure));
        statusBar.keepNote(sentence, () -> failing.getAsBoolean() && workspace.isChanged());
    }
}
