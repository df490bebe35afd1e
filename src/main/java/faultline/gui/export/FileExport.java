package faultline.gui.export;

import java.io.IOException;
import java.io.OutputStream;

/** Something that can be written to a file, off the event dispatch thread. */
interface FileExport {

    /**
     * Writes it.
     *
     * @param out where to; not closed
     * @param progress to be told how far it is
     * @throws IOException if it cannot be written
     * @throws java.util.concurrent.CancellationException if the user thinks better of it
     */
    void write(OutputStream out, ProgressListener progress) throws IOException;
}
