package faultline.gui.document;

import faultline.engine.session.Session;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.util.concurrent.CompletableFuture;

/** A document and the session that runs it. */
record OpenDocument(ScenarioDocument document, Session session) {

    /** Starts a session of a document, with the controller that is chosen in its workspace. */
    static OpenDocument start(ScenarioDocument document, Workspace workspace) {
        return new OpenDocument(
                document,
                Session.start(workspace.withChosenController(document.initial().setup())));
    }

    /**
     * Returns the scenario as edited by all commands that have been sent. The future completes on the event dispatch
     * thread, after their results. If the session has ended, these are the edits that are known.
     */
    CompletableFuture<Scenario> edited() {
        // The session answers in order, so the results of earlier commands are already in the queue.
        return session.journal().handleAsync((journal, ended) -> document.edited(), EventQueue::invokeLater);
    }
}
