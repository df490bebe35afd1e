package faultline.gui.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.document.RecoveryStore.RecoveredFile;
import faultline.scenario.Scenario;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import org.junit.jupiter.api.Test;

/** A user who is to decide about the edits of a crash can read which ones they are. */
class RecoveryQuestionTest {

    private static final Path ROOM = Path.of("rooms/room.xml").toAbsolutePath();
    private static final String WRITTEN = "\nLast change kept: 2026-03-04 05:06";

    private static RecoveredFile recovered(Path origin) throws Exception {
        LocalDateTime time = LocalDateTime.of(2026, 3, 4, 5, 6, 59);
        Scenario office = Scenario.loadShipped("office.xml");
        return new RecoveredFile(
                Path.of("1-0.xml"), time.atZone(ZoneId.systemDefault()).toInstant(), origin, null, office);
    }

    private static String question(String name) {
        return "Faultline ended unexpectedly. Recover the unsaved changes to " + name + "?";
    }

    @Test
    void theQuestionNamesTheFileItsFolderAndTheTimeOfTheEdits() throws Exception {
        String expected = question("room.xml") + "\nFolder: " + ROOM.getParent() + WRITTEN;
        assertEquals(expected, RecoveryQuestion.text(recovered(ROOM), null));
        assertEquals(expected, RecoveryQuestion.text(recovered(ROOM), Path.of("rooms/../rooms/room.xml")));
    }

    @Test
    void theQuestionNamesAnotherFileThatTheUserHasAskedToOpen() throws Exception {
        String text = RecoveryQuestion.text(recovered(ROOM), Path.of("other.xml"));
        assertEquals("Recovered changes are shown instead of other.xml.", text.substring(text.lastIndexOf('\n') + 1));
    }

    @Test
    void editsOfAScenarioWithoutAFileHaveNoFolder() throws Exception {
        assertEquals(question("Office") + WRITTEN, RecoveryQuestion.text(recovered(null), null));
    }
}
