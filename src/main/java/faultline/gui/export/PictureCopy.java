package faultline.gui.export;

import faultline.gui.text.Texts;
import faultline.paint.Shot;
import java.awt.datatransfer.Clipboard;
import java.awt.image.BufferedImage;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;

/** Puts a picture on the clipboard; it is painted off the event dispatch thread, because so fine a one takes as long as several frames. */
final class PictureCopy extends SwingWorker<BufferedImage, Void> {

    private final Shot shot;
    private final double fineness;
    private final Clipboard clipboard;
    private final Consumer<Throwable> failed;

    PictureCopy(Shot shot, double fineness, Clipboard clipboard, Consumer<Throwable> failed) {
        this.shot = shot;
        this.fineness = fineness;
        this.clipboard = clipboard;
        this.failed = failed;
    }

    @Override
    protected BufferedImage doInBackground() {
        return shot.image(fineness);
    }

    @Override
    protected void done() {
        try {
            clipboard.setContents(new ImageOnClipboard(get()), null);
        } catch (ExecutionException broken) {
            failed.accept(broken.getCause());
        } catch (IllegalStateException busy) {
            failed.accept(new IllegalStateException(Texts.text("note.clipboardBusy"), busy));
        } catch (InterruptedException broken) {
            Thread.currentThread().interrupt();
        }
    }
}
