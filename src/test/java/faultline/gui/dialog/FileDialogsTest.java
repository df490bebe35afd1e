package faultline.gui.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.text.Messages;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
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
        assertEquals(Path.of(saved), FileDialogs.withExtension(Path.of(typed), "xml", List.of("xml")));
    }

    @ParameterizedTest
    @CsvSource({
        "room, faultline, room.faultline",
        "room.xml, faultline, room.xml",
        "room.Faultline, xml, room.Faultline",
        "room, xml, room.xml"
    })
    void aScenarioIsSavedWithEitherOfItsExtensions(String typed, String suggested, String saved) {
        List<String> allowed = FileDialogs.extensions(FileDialogs.filterName("saveAs", suggested));
        assertEquals(Path.of(saved), FileDialogs.withExtension(Path.of(typed), suggested, allowed));
    }

    @Test
    void filesThatADesktopOpensAreOfferedAsScenariosAndNotAsPlans() {
        assertEquals(List.of("xml", "faultline"), FileDialogs.extensions(FileDialogs.filterName("open", "xml")));
        assertEquals(List.of("xml"), FileDialogs.extensions(FileDialogs.filterName("batchPlan", "xml")));
        assertTrue(Messages.get("files.filter.xml").contains("*.faultline"));
    }

    @Test
    void aNameThatTheFileSystemRefusesIsNoPath() {
        assertTrue(FileDialogs.isPath(new File("what?.xml")) || File.separatorChar == '\\');
        assertFalse(FileDialogs.isPath(new File("a\0b.xml")));
    }

    @Test
    void aFileToOpenThatDoesNotExistIsNamedWithItsFolder(@TempDir Path folder) throws IOException {
        File missing = folder.resolve("mistyped/nothing.yaml").toFile();
        assertEquals(Optional.of(missing + " does not exist."), FileDialogs.problem(missing, true));
        assertEquals(Optional.empty(), FileDialogs.problem(missing, false));
        File present = Files.createFile(folder.resolve("plan.yaml")).toFile();
        assertEquals(Optional.empty(), FileDialogs.problem(present, true));
        assertEquals(
                Optional.of("a\0b.xml is not a valid file name."), FileDialogs.problem(new File("a\0b.xml"), false));
    }

    @Test
    void aFileIsSavedInAFolderAndNotInPlaceOfOne(@TempDir Path folder) throws IOException {
        File taken = Files.createDirectory(folder.resolve("plan.xml")).toFile();
        assertEquals(Optional.of("plan.xml is a folder. Enter another name."), FileDialogs.savingProblem(taken));
        assertEquals(
                Optional.of(folder.resolve("missing") + " does not exist."),
                FileDialogs.savingProblem(folder.resolve("missing/plan.xml").toFile()));
        assertEquals(
                Optional.empty(),
                FileDialogs.savingProblem(folder.resolve("new.xml").toFile()));
        assertEquals(Optional.empty(), FileDialogs.savingProblem(new File("new.xml")));
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no files for devices")
    void aDeviceIsNotWritten() {
        assertEquals(
                Optional.of("null is a device or a pipe. Enter another name."),
                FileDialogs.savingProblem(new File("/dev/null")));
    }

    @ParameterizedTest
    @CsvSource({
        "saveAs, xml, xml",
        "saveAs, faultline, xml",
        "saveJournal, xml, xml",
        "batchPlan, xml, batchPlan",
        "exportPng, png, png"
    })
    void theFilterOfAChooserNamesWhatItShows(String action, String extension, String filter) {
        assertEquals(filter, FileDialogs.filterName(action, extension));
        assertTrue(Messages.contains("files.filter." + filter));
    }
}
