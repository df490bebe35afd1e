package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.session.Session;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.util.List;
import java.util.concurrent.CompletableFuture;

/**
 * A document and the session that runs it.
 *
 * @param ownController whether the session has the scenario's controller although another one may be chosen
 */
record OpenDocument(ScenarioDocument document, Session session, boolean ownController) {

    /** Starts a session of a document with its own controller, or with the one that is chosen in its workspace. */
    static OpenDocument start(ScenarioDocument document, boolean ownController, Workspace workspace) {
        SimulationSetup setup = document.initial().setup();
        Session session = Session.start(ownController ? setup : workspace.withChosenController(setup));
        return new OpenDocument(document, session, ownController);
    }

    /**
     * Returns the ids of the sensors of the run, which are earlier ones if the simulation of a renaming was cancelled.
     */
    List<String> sensorIds() {
        return session.frame().snapshot().robot().sensorIds();
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
