package faultline.gui.document;

import faultline.engine.Session;

/**
 * What lies on the bench.
 *
 * @param document the scenario
 * @param session its run
 */
record Work(Document document, Session session) {

    /** A document with a session that begins. */
    static Work begin(Document document) {
        return new Work(document, Session.start(document.begun().setup()));
    }

    Work with(Document newDocument) {
        return new Work(newDocument, session);
    }
}
