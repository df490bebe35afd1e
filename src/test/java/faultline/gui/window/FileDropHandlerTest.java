package faultline.gui.window;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.Test;

class FileDropHandlerTest {

    private final List<List<Path>> opened = new ArrayList<>();
    private final FileDropHandler drop = new FileDropHandler(opened::add);

    @Test
    void theDroppedFilesArePassedOnAfterTheDrop() {
        runOnEdt(() -> {
            assertTrue(
                    drop.importData(support(new FileListTransferable(List.of(new File("a.xml"), new File("b.xml"))))));
            assertEquals(List.of(), opened, "the other program would wait for the answer to a question");
        });
        runOnEdt(() -> assertEquals(List.of(List.of(Path.of("a.xml"), Path.of("b.xml"))), opened));
    }

    @Test
    void droppedTextAndEmptyListsAreRejected() {
        assertFalse(drop.importData(support(new StringSelection("a.xml"))));
        assertFalse(drop.importData(support(new FileListTransferable(List.of()))));
        runOnEdt(() -> assertEquals(List.of(), opened));
    }

    private static TransferSupport support(Transferable what) {
        return new TransferSupport(new JPanel(), what);
    }

    private record FileListTransferable(List<File> files) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return flavor.equals(DataFlavor.javaFileListFlavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavor) {
            return files;
        }
    }
}
