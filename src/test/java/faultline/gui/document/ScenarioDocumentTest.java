package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** A scenario that is edited, compared with its file. */
class ScenarioDocumentTest {

    @Test
    void aRecordOfARunWhoseOnlyEditIsUndoneIsARecordAgain() throws ScenarioException {
        Scenario office = Scenario.load(Path.of("scenarios/office.xml"));
        Scenario saved = new Scenario(office.name(), office.description(), true, office.setup(), office.expectation());
        ScenarioDocument document = new ScenarioDocument(Path.of("saved.xml"), saved, saved);
        document.change(open -> open.withSetup(open.setup().withSeed(7)));
        assertTrue(document.isChanged());
        assertFalse(document.edited().recorded());
        document.change(open -> open.withSetup(office.setup()));
        assertEquals(saved, document.edited());
        assertFalse(document.isChanged());
    }
}
