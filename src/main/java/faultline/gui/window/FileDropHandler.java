package faultline.gui.window;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Opens, or imports, the first of the files that are dropped on the window. */
final class FileDropHandler extends TransferHandler {

    private final transient Consumer<Path> opener;

    FileDropHandler(Consumer<Path> opener) {
        this.opener = opener;
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!canImport(support)) {
            return false;
        }
        try {
            Object data = support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            if (data instanceof List<?> files && !files.isEmpty() && files.get(0) instanceof File file) {
                opener.accept(file.toPath());
                return true;
            }
            return false;
        } catch (UnsupportedFlavorException | IOException lost) {
            return false;
        }
    }
}
