package faultline.gui.export;

import faultline.gui.document.TaskProgress;
import java.io.IOException;
import java.io.OutputStream;

/** Writes an export to a file, on a background thread. */
@FunctionalInterface
interface FileExport {

    /**
     * Writes the export.
     *
     * @param out the file; not closed
     * @param progress receives the completed fraction
     * @throws IOException if the export cannot be written
     * @throws java.util.concurrent.CancellationException if the user cancels the export
     */
    void write(OutputStream out, TaskProgress progress) throws IOException;
}
