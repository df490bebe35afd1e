package faultline.gui.export;

import faultline.gui.document.BackgroundTasks;
import faultline.gui.text.Messages;
import faultline.paint.export.RenderRequest;
import java.awt.datatransfer.Clipboard;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;

/** Copies an image to the clipboard. It is painted in the background, because that takes as long as several frames. */
final class CopyImageTask {

    private CopyImageTask() {}

    static void start(
            RenderRequest request, double resolutionScale, Clipboard clipboard, Consumer<Throwable> onFailed) {
        BackgroundTasks.run(
                () -> request.toImage(resolutionScale), image -> copy(image, clipboard, onFailed), onFailed);
    }

    private static void copy(BufferedImage image, Clipboard clipboard, Consumer<Throwable> onFailed) {
        try {
            clipboard.setContents(new TransferableImage(image), null);
        } catch (IllegalStateException busy) {
            onFailed.accept(new IllegalStateException(Messages.get("note.clipboardBusy"), busy));
        }
    }
}
