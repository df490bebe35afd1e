package faultline.gui.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;

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
}
