package faultline.gui.export;

import faultline.gui.text.Messages;
import faultline.paint.export.RenderRequest;
import java.awt.datatransfer.Clipboard;
import java.awt.image.BufferedImage;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;

/**
 * Puts a picture on the clipboard; it is painted off the event dispatch thread, because so fine a one takes as long as
 * several frames.
 */
final class CopyImageTask extends SwingWorker<BufferedImage, Void> {

    private final RenderRequest renderRequest;
    private final double resolutionScale;
    private final Clipboard clipboard;
    private final Consumer<Throwable> onFailed;

    CopyImageTask(RenderRequest shot, double fineness, Clipboard clipboard, Consumer<Throwable> failed) {
        this.renderRequest = shot;
        this.resolutionScale = fineness;
        this.clipboard = clipboard;
        this.onFailed = failed;
    }

    @Override
    protected BufferedImage doInBackground() {
        return renderRequest.toImage(resolutionScale);
    }

    @Override
    protected void done() {
        try {
            clipboard.setContents(new TransferableImage(get()), null);
        } catch (ExecutionException broken) {
            onFailed.accept(broken.getCause());
        } catch (IllegalStateException busy) {
            onFailed.accept(new IllegalStateException(Messages.get("note.clipboardBusy"), busy));
        } catch (InterruptedException broken) {
            Thread.currentThread().interrupt();
        }
    }
}
