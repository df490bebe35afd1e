package faultline.gui.export;

import faultline.gui.document.TaskProgress;
import java.io.IOException;
import java.io.OutputStream;

/** Writes an export to a file, on a background thread. */
@FunctionalInterface
interface FileExport {

    /**
     * Writes the export to a file, which stays open. Throws a {@link java.util.concurrent.CancellationException} if the
     * user cancels it.
     */
    void write(OutputStream out, TaskProgress progress) throws IOException;
}
