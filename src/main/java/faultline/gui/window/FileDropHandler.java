package faultline.gui.window;

import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/**
 * Passes on the files that are dropped on the window. The drop has ended by then, so that the other program does not
 * wait for the answer to a question.
 */
final class FileDropHandler extends TransferHandler {

    private final transient Consumer<List<Path>> opener;

    FileDropHandler(Consumer<List<Path>> opener) {
        this.opener = opener;
    }

    /** Accepts files that may be copied: a program deletes files that it moves, which are only read here. */
    @Override
    public boolean canImport(TransferSupport support) {
        if (!support.isDataFlavorSupported(DataFlavor.javaFileListFlavor)) {
            return false;
        }
        if (support.isDrop()) {
            if ((support.getSourceDropActions() & COPY) == 0) {
                return false;
            }
            support.setDropAction(COPY);
        }
        return true;
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!canImport(support)) {
            return false;
        }
        try {
            Object data = support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            List<Path> files = data instanceof List<?> list
                    ? list.stream()
                            .filter(File.class::isInstance)
                            .map(file -> ((File) file).toPath())
                            .toList()
                    : List.of();
            if (files.isEmpty()) {
                return false;
            }
            EventQueue.invokeLater(() -> opener.accept(files));
            return true;
        } catch (UnsupportedFlavorException | IOException lost) {
            return false;
        }
    }
}
