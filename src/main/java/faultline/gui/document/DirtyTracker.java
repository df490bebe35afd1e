package faultline.gui.document;

import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.util.Optional;

/**
 * Finds out, without waiting, what commands to the run have made of the scenario: the window's mark of unsaved changes.
 */
final class DirtyTracker {

    private final Workspace workspace;
    private boolean stale;
    private boolean requestPending;

    DirtyTracker(Workspace bench) {
        this.workspace = bench;
    }

    /** Something may have changed the scenario since the last look. */
    void markStale() {
        stale = true;
    }

    /** Asks the run, if there is reason to. */
    void refresh() {
        if (stale && !requestPending) {
            workspace.openDocument().ifPresent(this::requestJournal);
        }
    }

    private void requestJournal(OpenDocument now) {
        stale = false;
        requestPending = true;
        now.session()
                .fullJournal()
                .thenApplyAsync(now.document()::editedBy)
                .whenComplete((edited, closed) ->
                        EventQueue.invokeLater(() -> journalReceived(now, Optional.ofNullable(edited))));
    }

    private void journalReceived(OpenDocument asked, Optional<Scenario> edited) {
        requestPending = false;
        boolean changedBefore = workspace.isChanged();
        edited.ifPresent(scenario -> workspace.updateDocument(asked, document -> document.withEdited(scenario)));
        if (workspace.isChanged() != changedBefore) {
            workspace.listener().titleChanged();
        }
    }
}
