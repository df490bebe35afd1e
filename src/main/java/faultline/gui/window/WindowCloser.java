package faultline.gui.window;

import faultline.gui.batch.BatchActions;
import faultline.gui.dialog.FileController;
import faultline.gui.document.Leaving;
import faultline.gui.export.ExportController;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JFrame;

/**
 * Closes the window when the user wants it, after questions about what would be lost: exports, results of a batch and
 * changes of the scenario.
 */
final class WindowCloser extends WindowAdapter {

    private final JFrame window;
    private final WindowBounds windowBounds;
    private final ExportController exportController;
    private final BatchActions batchActions;
    private final FileController fileController;

    WindowCloser(
            JFrame window,
            WindowBounds windowBounds,
            ExportController exportController,
            BatchActions batchActions,
            FileController fileController) {
        this.window = window;
        this.windowBounds = windowBounds;
        this.exportController = exportController;
        this.batchActions = batchActions;
        this.fileController = fileController;
    }

    @Override
    public void windowClosing(WindowEvent event) {
        quit();
    }

    /** Closes the window unless the user cancels it. */
    void quit() {
        Leaving.begin(leaving -> {
            // The window may have been closed while a file was written.
            if (window.isDisplayable()) {
                quit(leaving);
            }
        });
    }

    private void quit(Leaving leaving) {
        Runnable changes = () -> fileController.runIfChangesHandled(leaving, this::close);
        exportController.exports().runIfHandled(leaving, () -> batchActions.runIfResultsHandled(leaving, changes));
    }

    private void close() {
        windowBounds.save();
        window.dispose();
    }
}
