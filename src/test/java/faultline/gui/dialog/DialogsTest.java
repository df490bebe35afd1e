package faultline.gui.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.document.TaskKind;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The sentences of dialogs. */
class DialogsTest {

    @Test
    void aFailureNamesTheFileAndARootFolderByItsPath() {
        Path root = Path.of("").toAbsolutePath().getRoot();
        IOException cause = new IOException("this is a folder");
        assertEquals(root + " cannot be opened: this is a folder.", Dialogs.failureText(TaskKind.OPEN, root, cause));
        assertEquals(
                "room.xml cannot be opened: this is a folder.",
                Dialogs.failureText(TaskKind.OPEN, root.resolve("room.xml"), cause));
    }

    @Test
    void whoOpensAMapAsAScenarioLearnsHowToImportIt() {
        assertEquals(
                "room.xml cannot be opened. The current scenario remains open.",
                Dialogs.headingText(Path.of("room.xml"), true));
        assertEquals(
                "map.PNG cannot be opened. File > Import floor plan opens maps and images. An example is open instead.",
                Dialogs.headingText(Path.of("map.PNG"), false));
    }
}
