package faultline.gui.export;

import faultline.gui.document.BackgroundTasks;
import faultline.gui.text.Messages;
import faultline.paint.export.RenderRequest;
import java.awt.Image;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.util.function.Consumer;

/** An image for the clipboard. */
record TransferableImage(Image image) implements Transferable {

    /**
     * Renders an image in the background, because that takes as long as several frames, and copies it. Calls one of the
     * callbacks on the event dispatch thread.
     */
    static void copy(
            RenderRequest request,
            double resolutionScale,
            Clipboard clipboard,
            Runnable onCopied,
            Consumer<Throwable> onFailed) {
        BackgroundTasks.compute(
                () -> request.toImage(resolutionScale),
                image -> {
                    try {
                        clipboard.setContents(new TransferableImage(image), null);
                        onCopied.run();
                    } catch (IllegalStateException busy) {
                        onFailed.accept(new IllegalStateException(Messages.get("note.clipboardBusy"), busy));
                    }
                },
                onFailed);
    }

    @Override
    public DataFlavor[] getTransferDataFlavors() {
        return new DataFlavor[] {DataFlavor.imageFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
        return DataFlavor.imageFlavor.equals(flavor);
    }

    @Override
    public Object getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
        if (!isDataFlavorSupported(flavor)) {
            throw new UnsupportedFlavorException(flavor);
        }
        return image;
    }
}
