package faultline.gui.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.text.Messages;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** File names with their extensions. */
class FileDialogsTest {

    @ParameterizedTest
    @CsvSource({
        "room, room.xml",
        "room.xml, room.xml",
        "room.XML, room.XML",
        "room.v2, room.v2.xml",
        "xml, xml.xml",
        "a.b/room, a.b/room.xml"
    })
    void aNameGetsItsExtensionUnlessItHasIt(String typed, String saved) {
        assertEquals(Path.of(saved), FileDialogs.withExtension(Path.of(typed), "xml"));
    }

    @ParameterizedTest
    @CsvSource({"saveAs, xml, xml", "saveJournal, xml, xml", "batchPlan, xml, batchPlan", "exportPng, png, png"})
    void theFilterOfAChooserNamesWhatItShows(String action, String extension, String filter) {
        assertEquals(filter, FileDialogs.filterName(action, extension));
        assertTrue(Messages.contains("files.filter." + filter));
    }
}
