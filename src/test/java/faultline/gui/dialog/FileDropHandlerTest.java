package faultline.gui.dialog;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.FileTransferable;
import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FileDropHandlerTest {

    private final List<List<Path>> opened = new ArrayList<>();
    private final List<String> notes = new ArrayList<>();
    private final FileDropHandler drop = new FileDropHandler(opened::add, notes::add);

    @Test
    void theDroppedFilesArePassedOnAfterTheDrop() {
        runOnEdt(() -> {
            assertTrue(drop.importData(support(new FileTransferable(List.of(new File("a.xml"), new File("b.xml"))))));
            assertEquals(List.of(), opened, "the other program would wait for the answer to a question");
        });
        runOnEdt(() -> assertEquals(List.of(List.of(Path.of("a.xml"), Path.of("b.xml"))), opened));
    }

    @Test
    void droppedTextAndEmptyListsAreRejected() {
        assertFalse(drop.importData(support(new StringSelection("a.xml"))));
        assertFalse(drop.importData(support(new FileTransferable(List.of()))));
        runOnEdt(() -> assertEquals(List.of(), opened));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"http://example.org/a.xml", "sftp://localhost/a.xml", "file://other/a.xml", "file://localhost/%"
            })
    void aLinkThatIsNoFileOfThisComputerIsRefusedWithANote(String link) {
        assertFalse(drop.importData(support(new LinkTransferable(link + "\r\n"))));
        runOnEdt(() -> assertEquals(List.of(), opened));
        assertEquals(List.of("Only files on this computer can be opened"), notes);
    }

    @Test
    void aFileWithTheNameOfThisHostIsPassedOn() {
        assertTrue(drop.importData(support(new LinkTransferable("# comment\r\nfile://localhost/tmp/a%20b.xml\r\n"))));
        runOnEdt(() -> assertEquals(List.of(List.of(Path.of(URI.create("file:///tmp/a%20b.xml")))), opened));
        assertEquals(List.of(), notes);
    }

    /** The file system refuses some names, such as those with letters that the encoding of the locale lacks. */
    @Test
    void aFileWithANameThatTheFileSystemRefusesIsLeftOut() throws Exception {
        File good = new File("a.xml");
        File bad = new File("b\0.xml");
        assertFalse(drop.importData(support(new FileTransferable(List.of(bad)))));
        assertTrue(drop.importData(support(new FileTransferable(List.of(good, bad)))));
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of(List.of(good.toPath())), opened);
        String note = "b\0.xml is not a valid file name.";
        assertEquals(List.of(note, note), notes);
    }

    private static TransferSupport support(Transferable what) {
        return new TransferSupport(new JPanel(), what);
    }

    /** Links as a file manager passes them on, in none of which Java finds a file. */
    private record LinkTransferable(String links) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor, FileDropHandler.URI_LIST};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return List.of(getTransferDataFlavors()).contains(flavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavor) {
            return flavor.equals(DataFlavor.javaFileListFlavor) ? List.of() : links;
        }
    }
}
