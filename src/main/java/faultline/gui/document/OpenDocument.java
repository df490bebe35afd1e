package faultline.gui.document;

import faultline.engine.session.Session;

/**
 * What lies on the bench.
 *
 * @param document the scenario
 * @param session its run
 */
record OpenDocument(ScenarioDocument document, Session session) {

    /** A document with a session that begins. */
    static OpenDocument create(ScenarioDocument document) {
        return new OpenDocument(document, Session.start(document.initial().setup()));
    }

    OpenDocument withDocument(ScenarioDocument newDocument) {
        return new OpenDocument(newDocument, session);
    }
}
